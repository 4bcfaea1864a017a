#include "text/rounding.hpp"

#include <cmath>

namespace tiltrotor::text {

namespace {

// rad, in, m/s: less than kUsualTerms of trim's deg, in, m/s.
constexpr double point_terms = 1;

}  // namespace

double without_rounding(double value, double terms) {
  return std::isfinite(terms) && std::abs(value) < kRounding * terms ? 0 : value;
}

Vec3<double> without_rounding(const Vec3<double>& v, double terms) {
  return {without_rounding(v.x, terms), without_rounding(v.y, terms), without_rounding(v.z, terms)};
}

LinearModel<double> without_rounding(const LinearModel<double>& model) {
  LinearModel<double> shown = model;
  for (int i = 0; i < model.states; ++i) {
    double terms = 0;
    const auto state_size = [&](int j) { return kStateVariables[model.state[j]].facts().bend; };
    const auto control_size = [&](int j) { return kControlVariables[model.control[j]].facts().bend; };
    for (int j = 0; j < model.states; ++j) terms += std::abs(model.a(i, j)) * state_size(j);
    for (int j = 0; j < model.controls; ++j) terms += std::abs(model.b(i, j)) * control_size(j);
    for (int j = 0; j < model.states; ++j)
      shown.a(i, j) = without_rounding(model.a(i, j), terms / state_size(j));
    for (int j = 0; j < model.controls; ++j)
      shown.b(i, j) = without_rounding(model.b(i, j), terms / control_size(j));
    shown.x[i] = without_rounding(model.x[i], point_terms);
  }
  for (int j = 0; j < model.controls; ++j) shown.u[j] = without_rounding(model.u[j], point_terms);
  return shown;
}

}  // namespace tiltrotor::text
