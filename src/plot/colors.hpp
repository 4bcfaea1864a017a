// Colours of the figures. The line colours are those of Okabe and Ito, told apart with any colour vision; the
// fill colours run from orange (unstable) over white to blue (stable) and stay ordered in grey print on each
// side.
#pragma once

namespace tiltrotor::plot {

inline constexpr const char* kBlue = "#0072b2";
inline constexpr const char* kOrange = "#d55e00";
inline constexpr const char* kGreen = "#009e73";
inline constexpr const char* kPurple = "#b3508f";
inline constexpr const char* kAmber = "#c98500";
inline constexpr const char* kSky = "#3a9fd8";
inline constexpr const char* kBlack = "#222222";
inline constexpr const char* kGrey = "#777777";

inline constexpr int kLineColors = 8;
inline constexpr const char* kLineColor[kLineColors] = {kBlue,  kOrange, kGreen, kPurple,
                                                        kAmber, kSky,    kBlack, kGrey};

}  // namespace tiltrotor::plot
