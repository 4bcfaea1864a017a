// Law of atmospheric turbulence: scale and intensity of Dryden's spectra against height, MIL-F-8785C section 3.7, and
// how alike the gusts at two rotors are. TURBULENCE.md has the formulas and what they leave out.
#pragma once

#include "tiltrotor/math/hyperbolic_tangent.hpp"
#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tiltrotor {

// What turbulence depends on.
template <class T>
struct TurbulentAir {
  T height;      // above the ground, m; held at a lowest one
  T airspeed;    // m/s, not negative; held at the convection speed of the filters
  T wind_20_ft;  // wind 20 ft above the ground, which says how strong it is (GustTables::wind_light ..), m/s
};

// Along x, y, z of the body.
template <class T>
struct DrydenLaw {
  Vec3<T> scale;      // m
  Vec3<T> intensity;  // standard deviation at a point, m/s
};

namespace dryden_detail {

// Newton's iteration, with the same bits everywhere. 0.05 <= x <= 1.
template <class T>
T fifth_root(const T& x) {
  using R = Real<T>;
  T root = R(0.66) + R(0.34) * x;
  for (int i = 0; i < 6; ++i) root = R(0.2) * (R(4) * root + x / square(square(root)));
  return root;
}

// e^-x, 0 <= x <= 10.
template <class T>
T decay(const T& x) {
  using R = Real<T>;
  const T t = hyperbolic_tangent(T(R(0.5) * x));
  return (R(1) - t) / (R(1) + t);
}

}  // namespace dryden_detail

// Near the ground L_w = h, L_u = L_v = h / s^1.2, sigma_w = 0.1 W20, sigma_u = sigma_v = sigma_w / s^0.4 with s from
// 0.177 at the ground to 1 at 1000 ft; above 2000 ft all alike; linear between.
template <class T>
DrydenLaw<T> dryden_law(const TurbulentAir<T>& air, const GustTables<Real<T>>& g) {
  using R = Real<T>;
  const T low = smooth_clip(air.height, g.lowest_height, g.low_height, g.height_width);
  const T between = smooth_clip(air.height, g.low_height, g.high_height, g.height_width);
  const T above = (between - g.low_height) / (g.high_height - g.low_height);

  const T shape = g.ground_shape + (R(1) - g.ground_shape) * low / g.low_height;
  const T root = dryden_detail::fifth_root(shape);
  const T level_scale = low / (shape * root);
  const T vertical = g.vertical_intensity * air.wind_20_ft;
  const T level = vertical / square(root);
  const T high = g.high_intensity * air.wind_20_ft;

  const auto at_height = [&above](const T& near_ground, const T& far_above) {
    return near_ground + above * (far_above - near_ground);
  };
  const T scale = at_height(level_scale, T(g.high_length));
  const T intensity = at_height(level, high);
  return {{scale, scale, at_height(low, T(g.high_length))},
          {intensity, intensity, at_height(vertical, high)}};
}

// Between the two hubs, m.
template <class R>
R hub_distance(const MastTables<R>& mast) {
  return R(2) * (mast.bl_pivot + mast.length * sin(mast.cant));
}

// Correlation of each component at the two rotors: a distance d to the side, isotropic turbulence. What blows along that
// line keeps e^(-d/L); what blows across, (1 - d/2L) e^(-d/L).
template <class T>
Vec3<T> rotor_correlation(const DrydenLaw<T>& law, const MastTables<Real<T>>& mast) {
  using R = Real<T>;
  const R d = hub_distance(mast);
  const T level = d / law.scale.x;
  const T vertical = d / law.scale.z;
  const T level_decay = dryden_detail::decay(level);
  return {(R(1) - R(0.5) * level) * level_decay, level_decay,
          (R(1) - R(0.5) * vertical) * dryden_detail::decay(vertical)};
}

}  // namespace tiltrotor
