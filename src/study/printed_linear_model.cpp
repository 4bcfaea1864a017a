#include "study/printed_linear_model.hpp"

#include <cmath>
#include <stdexcept>

#include "study/missing.hpp"
#include "study/printed_flights.hpp"
#include "study/reference_points.hpp"

namespace tiltrotor::study {

namespace {

struct Named {
  const char* name;
  int place;
  double unit;  // of the print, SI
};
constexpr Named kPrintedStates[] = {
    {"u", kStateIndex.velocity.x, kFoot}, {"v", kStateIndex.velocity.y, kFoot},
    {"w", kStateIndex.velocity.z, kFoot}, {"p", kStateIndex.rates.x, 1},
    {"q", kStateIndex.rates.y, 1},        {"r", kStateIndex.rates.z, 1},
    {"phi", kStateIndex.roll, 1},         {"theta", kStateIndex.pitch, 1}};
constexpr Named kPrintedControls[] = {{"long_stick", kControlIndex.long_stick, 1},
                                      {"power_lever", kControlIndex.collective, 1},
                                      {"lat_stick", kControlIndex.lat_stick, 1},
                                      {"pedal", kControlIndex.pedal, 1}};

template <std::size_t N>
const Named& named(const Named (&all)[N], const std::string& name) {
  for (const Named& n : all) {
    if (name == n.name) return n;
  }
  throw std::runtime_error("linear_model_gtrs.csv: unknown name '" + name + "'");
}

// With eps' = c x + d eps and x' = A x + a eps, eps is to first order in 1/d
//
//   eps = -c x / d - c x' / d^2,   so   (1 + a c/d^2) x' = (A - a c/d) x,
//
// whose right side is the quasi-steady one; the inverse at the left is 1 - a c / (d^2 + c a).
void delay_downwash(const Linear& full, Linear& reduced) {
  const int r = kRigidStates;
  int eps = r;
  while (eps < full.states && full.state[eps] != kStateIndex.downwash) ++eps;
  if (eps == full.states) return;
  const double d = full.a(eps, eps);
  double ca = 0;
  for (int k = 0; k < r; ++k) ca += full.a(eps, k) * full.a(k, eps);
  const auto correct = [&](const auto& entry, int columns) {
    for (int j = 0; j < columns; ++j) {
      double drive = 0;
      for (int k = 0; k < r; ++k) drive += full.a(eps, k) * entry(k, j);
      for (int i = 0; i < r; ++i) entry(i, j) -= full.a(i, eps) * drive / (d * d + ca);
    }
  };
  correct([&](int i, int j) -> double& { return reduced.a(i, j); }, r);
  correct([&](int i, int j) -> double& { return reduced.b(i, j); }, reduced.controls);
}

}  // namespace

const std::vector<LinearTerm>& printed_terms() {
  static const std::vector<LinearTerm> all = [] {
    std::vector<LinearTerm> terms;
    const Table printed = reference_points("linear_model_gtrs");
    for (std::size_t i = 0; i < printed.rows(); ++i) {
      terms.push_back({printed.text(i, "matrix"), printed.text(i, "row"), printed.text(i, "column"),
                       printed.number(i, "value")});
    }
    return terms;
  }();
  return all;
}

Setup printed_model_setup(ComparedAircraft aircraft) {
  return printed_setup(aircraft, reference_points("modes_gtrs"), 0);
}

Linear printed_states(const Setup& setup, const Aircraft<double>& aircraft, DownwashDelay delay) {
  const double speed = kKnot * reference_points("modes_gtrs").number(0, "speed_kt");
  const Configured c = configured(setup, aircraft);
  const Trimmed t = trimmed_persistently(c, speed);
  const Linear full = linear_model(c, t);
  Linear reduced = quasi_steady(full);
  if (delay == DownwashDelay::first_order) delay_downwash(full, reduced);
  return reduced;
}

std::vector<double> terms_of(const Linear& model) {
  std::vector<double> here;
  double per_lever = kMissing;
  for (const LinearTerm& term : printed_terms()) {
    const bool is_a = term.matrix == "A";
    const Named& row = named(kPrintedStates, term.row);
    const Named& of = is_a ? named(kPrintedStates, term.column) : named(kPrintedControls, term.column);
    double value = (is_a ? state_derivative(model, row.place, of.place)
                         : control_derivative(model, row.place, of.place)) *
                   of.unit / row.unit;
    if (term.column == "power_lever") {
      if (std::isnan(per_lever)) per_lever = term.printed / value;
      value *= per_lever;
    }
    here.push_back(value);
  }
  return here;
}

}  // namespace tiltrotor::study
