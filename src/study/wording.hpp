// Numbers in sentences.
#pragma once

#include <string>

namespace tiltrotor::study {

// With that many decimals: fixed(-0.456, 2) is "-0.46".
std::string fixed(double value, int decimals);
// With its sign: "+0.46".
std::string with_sign(double value, int decimals);
// "-0.12 +- 0.34i", or the real part alone.
std::string root_text(double real, double imag);
// "Lateral"
std::string capitalized(std::string word);
// "mast 30 deg"
std::string mast_text(double mast_deg);

}  // namespace tiltrotor::study
