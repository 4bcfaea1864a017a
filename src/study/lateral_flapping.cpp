// Lateral flapping in helicopter flight, which the fore-aft gradient of the inflow makes: the reference
// simulation's beside what each published gradient law gives.

#include <cmath>

#include "study/printed_flights.hpp"
#include "study/sections.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

namespace {

struct Law {
  const char* name;
  const char* column;
  InflowGradient gradient;
  InflowShape shape;
};
constexpr Law kLaws[] = {
    {"no gradient", "uniform_deg", InflowGradient::pitt_peters, InflowShape::uniform},
    {"Pitt and Peters", "pitt_peters_deg", InflowGradient::pitt_peters, InflowShape::pitt_peters},
    {"Coleman", "coleman_deg", InflowGradient::coleman, InflowShape::pitt_peters},
    {"White and Blake", "white_blake_deg", InflowGradient::white_blake, InflowShape::pitt_peters},
};

double lateral_flapping_deg(const Table& printed, std::size_t row, const Law& law) {
  Setup setup = printed_setup(ComparedAircraft::as_simulated, printed, row);
  setup.options.inflow_gradient = law.gradient;
  setup.options.inflow = law.shape;
  const Trimmed t = trimmed_persistently(configured(setup), kKnot * printed.number(row, "speed_kt"));
  return is_trimmed(t.status) ? degrees(t.state.rotor[right].b1s) : kMissing;
}

}  // namespace

Section lateral_flapping() {
  Section section{"flapping", "Lateral flapping and the gradient of the inflow", "", {}, {}, {}};
  section.reading =
      "Inflow that grows from the leading to the trailing edge of the disk tilts it sideways. Printed trims of the "
      "reference simulation at mast 0 beside the same trims here under each gradient law that the model has "
      "(switches inflow and inflow_gradient); lateral cyclic and elevator gearing as in the printed runs.";
  const Table printed = reference_points("flapping_gtrs");
  std::vector<std::string> columns = {"speed_kt", "printed_deg"};
  for (const Law& law : kLaws) columns.push_back(law.column);
  Table table(columns);
  double error[std::size(kLaws)] = {};
  for (std::size_t i = 0; i < printed.rows(); ++i) {
    const double there = printed.number(i, "lat_flap_deg");
    std::vector<Table::Cell> row = {printed.number(i, "speed_kt"), there};
    for (std::size_t k = 0; k < std::size(kLaws); ++k) {
      const double here = lateral_flapping_deg(printed, i, kLaws[k]);
      row.push_back(here);
      error[k] += std::abs(here - there) / static_cast<double>(printed.rows());
    }
    table.add(row);
  }
  section.tables.push_back({"lateral_flapping", "lateral flapping b1s, - disk outboard, deg", table, true});

  std::size_t best = 0;
  std::string found = "Mean difference in deg: ";
  for (std::size_t k = 0; k < std::size(kLaws); ++k) {
    if (error[k] < error[best]) best = k;
    found += (k > 0 ? ", " : "") + std::string(kLaws[k].name) + " " + fixed(error[k], 2);
  }
  section.findings.push_back({Finding::remark, "Which law the reference simulation uses is not public.",
                              found + ". Nearest: " + kLaws[best].name +
                                  ". Pitt and Peters stays the default: it is the one with a "
                                  "theory and measurements behind it."});
  return section;
}

}  // namespace tiltrotor::study
