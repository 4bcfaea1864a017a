#include "study/validation_rules.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study/missing.hpp"
#include "study/reference_points.hpp"

namespace tiltrotor::study {

namespace {

bool fits(const std::string& pattern, const std::string& quantity) {
  if (pattern.empty() || pattern.back() != '*') return pattern == quantity;
  return quantity.compare(0, pattern.size() - 1, pattern, 0, pattern.size() - 1) == 0;
}

Tolerance::Demand demand_of(const std::string& word) {
  if (word.empty()) return Tolerance::Demand::equal;
  if (word == "at_least") return Tolerance::Demand::at_least;
  if (word == "at_most") return Tolerance::Demand::at_most;
  throw std::runtime_error("validation_tolerances.csv: unknown demand '" + word + "'");
}

}  // namespace

Tolerance tolerance_of(const std::string& set, const std::string& quantity, double mast_deg) {
  static const Table rules = reference_points("validation_tolerances");
  for (std::size_t i = 0; i < rules.rows(); ++i) {
    if (rules.text(i, "set") != set || !fits(rules.text(i, "quantity"), quantity)) continue;
    const double mast = rules.number(i, "mast_deg");
    if (std::isfinite(mast) && mast != mast_deg) continue;
    const double absolute = rules.number(i, "tolerance");
    const double fraction = rules.number(i, "fraction");
    return {std::isfinite(absolute) || std::isfinite(fraction), std::isfinite(absolute) ? absolute : 0,
            std::isfinite(fraction) ? fraction : 0, demand_of(rules.text(i, "demand")),
            rules.text(i, "cause")};
  }
  throw std::runtime_error("validation_tolerances.csv: nothing about " + set + " " + quantity);
}

std::string cause_of(const Tolerance& tolerance, const std::string& set, const std::string& quantity,
                     double mast_deg, double difference) {
  if (tolerance.demand != Tolerance::Demand::equal && shortfall(tolerance, difference, 0) == 0)
    return "Nothing is left: the bound is met.";
  static const Table causes = reference_points("validation_causes");
  const char* side = difference > 0 ? "above" : "below";
  for (std::size_t i = 0; i < causes.rows(); ++i) {
    const double mast = causes.number(i, "mast_deg");
    if (causes.text(i, "set") == set && causes.text(i, "quantity") == quantity &&
        causes.text(i, "side") == side && (!std::isfinite(mast) || mast == mast_deg))
      return causes.text(i, "cause");
  }
  return tolerance.cause;
}

double allowed(const Tolerance& tolerance, double scale) {
  if (!tolerance.judged) return kMissing;
  return std::max(tolerance.absolute, tolerance.fraction * std::fabs(scale));
}

double shortfall(const Tolerance& tolerance, double here, double reference) {
  const double difference = here - reference;
  if (!std::isfinite(difference)) return kMissing;
  switch (tolerance.demand) {
    case Tolerance::Demand::at_least:
      return std::max(0.0, -difference);
    case Tolerance::Demand::at_most:
      return std::max(0.0, difference);
    default:
      return std::fabs(difference);
  }
}

}  // namespace tiltrotor::study
