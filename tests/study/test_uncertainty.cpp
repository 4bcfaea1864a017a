// The bands of doubtful inputs: how changes are combined, that each input moves what it names, exact derivatives of
// trims, and where bands stand in the figures.
// Expected: arithmetic by hand, the switches of the model that hold the other end of a range, differences of two trims,
// momentum theory.
#include "study/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "check.hpp"
#include "run_program.hpp"
#include "study/doubtful_inputs.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/trim_pictures.hpp"
#include "this_aircraft.hpp"

using tiltrotor::Aircraft;
using tiltrotor::aircraft_data;
using tiltrotor::ApparentMass;
using tiltrotor::ConfigurationParameter;
using tiltrotor::FinArea;
using tiltrotor::InertiaSet;
using tiltrotor::NacelleMass;
using tiltrotor::ParameterSet;
using tiltrotor::TailPressure;
using namespace tiltrotor::study;

namespace {

const DoubtfulInput& input_named(const std::string& name) {
  for (const DoubtfulInput& input : doubtful_inputs())
    if (input.name == name) return input;
  throw std::logic_error("no input " + name);
}

std::string file_text(const std::string& path) {
  std::ifstream in(check::source_path(path), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Table spreads(std::initializer_list<std::array<double, 3>> rows) {
  Table table({"x", "below", "above"});
  for (const auto& row : rows) table.add({row[0], row[1], row[2]});
  return table;
}

// The largest difference of rates between two configurations, with the stick a little off a trim of the first.
double difference(const Configured& a, const Configured& b, double speed) {
  Trimmed t = trimmed_persistently(a, speed);
  t.controls.long_stick += 0.2;
  double x[tiltrotor::state_count];
  double y[tiltrotor::state_count];
  flatten(evaluated(a, t.state, t.controls).rates, x);
  flatten(evaluated(b, t.state, t.controls).rates, y);
  double worst = 0;
  for (int i = 0; i < tiltrotor::state_count; ++i) worst = std::max(worst, std::fabs(x[i] - y[i]));
  return worst;
}

}  // namespace

TEST(report_uncertainty_combines_independent_changes) {
  const Spread none = root_sum_square({{0, 0}, {0, 0}});
  CHECK(none.below == 0 && none.above == 0);
  CHECK_EQ(share({0, 0}, none), 0.0);
  const Spread one = root_sum_square({{-2, 3}});
  CHECK(one.below == 2 && one.above == 3);
  const Spread turned = root_sum_square({{2, -3}});  // falls as the input grows
  CHECK(turned.below == 3 && turned.above == 2);
  const Spread one_sided = root_sum_square({{0, -5}});
  CHECK(one_sided.below == 5 && one_sided.above == 0);
  const Spread same_way = root_sum_square({{1, 4}});  // an extreme inside the range: the larger end counts
  CHECK(same_way.below == 0 && same_way.above == 4);
  const std::vector<EndChange> changes = {{-3, 3}, {-4, 4}};
  const Spread both = root_sum_square(changes);
  CHECK(both.below == 5 && both.above == 5);
  CHECK_NEAR(share(changes[0], both), 9.0 / 25, 1e-15);
  CHECK_NEAR(share(changes[0], both) + share(changes[1], both), 1, 1e-15);
  const Spread unknown = root_sum_square({{-1, 1}, {double(NAN), 1}});
  CHECK(std::isnan(unknown.below) && std::isnan(unknown.above));
}

TEST(report_band_without_width_is_the_curve) {
  tiltrotor::plot::Series curve;
  curve.x = {0, 1, 2, 3, 4, 5};
  curve.y = {7, -1, 2, 0, 5, 6};
  const auto band = band_around(curve, spreads({{1, 0, 0}, {4, 0, 0}}), "x");
  CHECK_EQ(band.x.size(), 4u);  // no further than the rows
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    CHECK(band.x[i] == curve.x[i + 1]);
    CHECK(band.low[i] == curve.y[i + 1] && band.high[i] == curve.y[i + 1]);
  }
  const auto wide = band_around(curve, spreads({{0, 1, 2}, {4, 3, 10}}), "x", 0.5);
  CHECK_EQ(wide.x.size(), 5u);
  CHECK_NEAR(wide.low[1], -1 - 0.5 * 1.5, 1e-12);
  CHECK_NEAR(wide.high[3], 0 + 0.5 * 8, 1e-12);
  const auto gap = band_around(curve, spreads({{0, 1, 1}, {2, double(NAN), double(NAN)}, {4, 1, 1}}), "x");
  CHECK(std::isfinite(gap.low[0]) && std::isnan(gap.low[1]) && std::isnan(gap.low[2]) &&
        std::isfinite(gap.low[4]));
  CHECK(band_around(curve, spreads({}), "x").x.empty());
  CHECK_EQ(band_around(curve, spreads({{2, 1, 1}}), "x").x.size(), 1u);
}

// The other end of a range that is a switch of the model.
TEST_OF_XV15(report_doubtful_inputs_reach_the_other_source) {
  const auto agrees = [](const char* name, double by, double mast, double speed, auto&& change,
                         double bound) {
    const Setup setup = default_setup(mast);
    Setup other = setup;
    change(other);
    const MovedAircraft moved(setup, input_named(name), by);
    const Configured expected = configured(other);
    if (!CHECK(difference(expected, moved.configuration(), speed) <=
               bound * difference(expected, configured(setup), speed)))
      NOTE(name);
    CHECK(difference(expected, configured(setup), speed) > 0);
  };
  const auto above = [](const char* name) { return input_named(name).above; };
  const auto below = [](const char* name) { return -input_named(name).below; };
  agrees(
      "nacelle_weight", above("nacelle_weight"), 60, 70,
      [](Setup& s) { s.options.nacelle_mass = NacelleMass::quoted; }, 1e-4);
  agrees(
      "inertia_pitch", above("inertia_pitch"), 90, 100,
      [](Setup& s) { s.options.inertia = InertiaSet::flown; }, 1e-9);
  agrees(
      "induced_power_factor", above("induced_power_factor"), 0, 0,
      [](Setup& s) { s.options.induced_power_factor = 1.1; }, 1e-9);
  agrees(
      "tail_pressure", below("tail_pressure"), 90, 100,
      [](Setup& s) { s.options.tail_pressure = TailPressure::by_mast; }, 1e-9);
  agrees(
      "hub_spring", above("hub_spring"), 0, 40, [](Setup& s) { s.options.hub_spring_factor = 1.04; }, 1e-9);
  agrees(
      "elevator_gearing", above("elevator_gearing"), 90, 100,
      [](Setup& s) { s.options.elevator_gearing = tiltrotor::ElevatorGearing::printed_runs; }, 0.01);
}

TEST_OF_XV15(report_doubtful_inputs_move_what_they_name) {
  const Setup setup = default_setup(30);
  const Aircraft<double>& base = aircraft_data<double>();
  const MovedAircraft apparent(setup, input_named("apparent_mass"), -input_named("apparent_mass").below);
  CHECK_NEAR(apparent.aircraft.inflow.apparent_mass_uniform, base.inflow.apparent_mass_loaded, 1e-4);
  const MovedAircraft fins(setup, input_named("fin_area"), -input_named("fin_area").below);
  CHECK_NEAR(fins.aircraft.fin.surface.area / base.fin.area_report, 1, 0.01);
  const MovedAircraft cg(setup, input_named("cg_station"), 0.5);
  CHECK_NEAR(cg.configuration().mass.sl_cg - configured(setup).mass.sl_cg, 0.0127, 1e-12);
  const MovedAircraft lift(setup, input_named("table_wing_lift"), 2);
  const auto at = [](const Aircraft<double>& a, double alpha) {
    return lookup(a.wing.lift_0[1], tiltrotor::Interpolation::c1, alpha);
  };
  for (const double alpha : {-7.3, 0.4, 11.9})
    CHECK_NEAR(at(lift.aircraft, alpha), 1.02 * at(base, alpha), 1e-14);
  const MovedAircraft wash(setup, input_named("wash_factor"), 0.4);
  CHECK_NEAR(wash.aircraft.wake.load_factor.at_0 * std::pow(wash.aircraft.wake.wash_factor, 2),
             base.wake.load_factor.at_0 * std::pow(base.wake.wash_factor, 2), 1e-12);
}

// Each names entries that are there, in a range that is one, with a reason; what is not known is refused by name.
TEST_OF_XV15(report_doubtful_inputs_are_complete) {
  const std::string entries = file_text("tables/xv15/aircraft.csv") + file_text("tables/xv15/choices.csv") +
                              file_text("tables/xv15/tables.csv") + "\nstandard atmosphere";
  const Table rows = reference_points("doubtful_inputs");
  CHECK_EQ(doubtful_inputs().size(), rows.rows());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    std::string rest = rows.text(i, "entry");
    while (!rest.empty()) {
      const std::size_t space = rest.find(' ');
      const std::string entry = rest.substr(0, space);
      if (!CHECK(entries.find("\n" + entry) != std::string::npos || entry == "atmosphere")) NOTE(entry);
      rest = space == std::string::npos ? "" : rest.substr(space + 1);
    }
    const DoubtfulInput& input = doubtful_inputs()[i];
    CHECK(input.below + input.above > 0 && input.reason.size() > 10);
  }
  std::string message;
  try {
    (void)parameter_of({"no_such_input", 1, 1, "ND", ""});
  } catch (const std::exception& error) {
    message = error.what();
  }
  CHECK(message.find("no_such_input") != std::string::npos);
}

// dz/dp by the implicit function theorem against trims on either side, for every exact parameter.
TEST_OF_XV15(report_trim_slopes_equal_differences_of_trims) {
  ParameterSet set{0, {}};
  std::vector<DoubtfulInput> inputs;
  for (const DoubtfulInput& input : doubtful_inputs()) {
    if (parameter_of(input) == ConfigurationParameter::count) continue;
    set.parameter[set.count++] = parameter_of(input);
    inputs.push_back(input);
  }
  CHECK(set.count >= 7);
  double worst = 0;
  for (const auto& [mast, speed] : {std::pair{0.0, 0.0}, {0.0, 40.0}, {45.0, 60.0}, {90.0, 100.0}}) {
    const Setup setup = default_setup(mast);
    const Configured c = configured(setup);
    const Trimmed trim = trimmed_persistently(c, speed);
    const std::vector<TrimNumbers> slopes = trim_sensitivity(c, trim, set);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const double by = 0.05;  // in the unit of the input
      const MovedAircraft low(setup, inputs[k], -by);
      const MovedAircraft high(setup, inputs[k], by);
      const TrimNumbers a = trim_numbers(trimmed_near(low.configuration(), speed, trim));
      const TrimNumbers b = trim_numbers(trimmed_near(high.configuration(), speed, trim));
      for (std::size_t q = 0; q < kTrimQuantities; ++q) {
        const double found = slopes[k][q] * parameter_amount(inputs[k], c, 2 * by);
        const double scale = q == 3 ? 1000 : 10;  // kW; deg and in
        const double error = std::fabs(found - (b[q] - a[q])) / scale;
        worst = std::max(worst, error);
        if (!CHECK(error < 1e-8)) NOTE(inputs[k].name << " " << kTrimQuantity[q] << " mast " << mast);
      }
    }
  }
  NOTE("slopes against differences of trims, of 10 deg, 10 in, 1000 kW: " << worst);
}

// A CG further aft, by prepare() alone, and the laws of hover: inertia is not felt, power goes with more than the
// weight and less than its power of 1.5 with profile drag, the nose comes up as the CG goes aft.
TEST(report_trim_slopes_obey_statics) {
  Setup setup = default_setup(0);
  setup.altitude = this_aircraft::altitude();
  const Configured c = configured(setup);
  const Trimmed trim = trimmed_persistently(c, 0);
  const auto slopes = trim_sensitivity(
      c, trim,
      {3, {ConfigurationParameter::sl_cg, ConfigurationParameter::mass, ConfigurationParameter::inertia_yy}});
  const double step = 0.001;
  setup.sl_cg += step;
  const TrimNumbers aft = trim_numbers(trimmed_near(configured(setup), 0, trim));
  setup.sl_cg -= 2 * step;
  const TrimNumbers forward = trim_numbers(trimmed_near(configured(setup), 0, trim));
  CHECK_NEAR(slopes[0][0], (aft[0] - forward[0]) / (2 * step), 1e-3);
  CHECK(slopes[0][0] > 0);
  const double power_exponent = slopes[1][3] * c.mass.mass / trim_numbers(trim)[3];
  CHECK(power_exponent > 1 && power_exponent < 1.7);
  for (const double slope : slopes[2]) CHECK_NEAR(slope * c.mass.inertia.yy, 0, 3e-10);
}

// Changes of numbers and tables are those of a second trim; each input acts somewhere; shares are parts of a whole.
TEST_OF_XV15(report_uncertainty_of_every_input) {
  const Uncertainty found = uncertainty();
  for (const DoubtfulInput& input : doubtful_inputs()) {
    const Table rows = found.parts.where("input", input.name);
    double most = 0;
    for (const char* end : {"at_low", "at_high"})
      for (const double change : rows.numbers(end)) most = std::max(most, std::fabs(change));
    if (!CHECK(most > 0)) NOTE(input.name);
  }
  for (std::size_t i = 0; i < found.points.rows(); ++i) {
    const Table parts = found.parts.where("point", found.points.text(i, "point"))
                            .where("quantity", found.points.text(i, "quantity"));
    double sum = 0;
    double squares = 0;
    for (std::size_t k = 0; k < parts.rows(); ++k) {
      sum += parts.number(k, "share");
      squares += std::pow(std::max({parts.number(k, "at_low"), parts.number(k, "at_high"), 0.0}), 2);
    }
    CHECK_NEAR(sum, 1, 1e-5);
    CHECK_NEAR(std::sqrt(squares), found.points.number(i, "above"), 1e-5 * (1e-3 + std::sqrt(squares)));
  }
  const Table digits = uncertainty_shares(found).tables[0].table;
  for (std::size_t i = 0; i < digits.rows(); ++i) {
    const double half = 0.5 * (digits.number(i, "below") + digits.number(i, "above"));
    const double off = std::fabs(digits.number(i, "rounded") - digits.number(i, "value"));
    CHECK(off <= half && std::isfinite(off));
    CHECK(!digits.text(i, "mostly").empty());
  }
  for (const double mast : kTrimMasts) CHECK(found.trim.where("mast_deg", mast).rows() > 0);
  CHECK(found.response.where("quantity", std::string("climb_mps")).rows() == 61);

  // One number by hand: power in hover with more section drag.
  const Setup setup = default_setup(0);
  const auto changes = trim_changes(setup, 0);
  std::size_t drag = 0;
  while (doubtful_inputs()[drag].name != "table_section_drag") ++drag;
  const MovedAircraft moved(setup, doubtful_inputs()[drag], doubtful_inputs()[drag].above);
  const double power = trim_numbers(trimmed_persistently(moved.configuration(), 0))[3];
  const double before = trim_numbers(trimmed_persistently(configured(setup), 0))[3];
  CHECK_NEAR(changes[drag][3].at_high, power - before, 1e-5);
  CHECK(power > before && power - before < 0.05 * before);
}

// Around the curves of the default aircraft, not around those of the simulated one.
TEST_OF_XV15(report_figures_carry_the_bands) {
  Sweeps sweeps;
  for (const double mast : kTrimMasts) sweeps.push_back(speed_sweep(mast, 20, 140));
  Uncertainty bands;
  for (const double mast : {0.0, 90.0})
    for (const double speed : {0.0, 140.0})
      for (const char* quantity : kTrimQuantity)
        bands.trim.add({mast, speed, std::string(quantity), 1.0, 0.5, 0.5});
  const Section section = trim_curves(sweeps, bands);
  for (const Picture& p : section.pictures) {
    const bool main = p.name == "trim_pitch" || p.name == "trim_stick" || p.name == "trim_collective" ||
                      p.name == "trim_power";
    CHECK_EQ(count(p.svg, "class=\"band\""), main ? 2u : 0u);
    CHECK_EQ(count(p.svg, "Band: "), main ? 1u : 0u);
  }
  for (const Picture& p : trim_curves(sweeps).pictures) CHECK_EQ(count(p.svg, "class=\"band\""), 0u);

  bands.response.add({0.0, std::string("climb_mps"), 0.0, 0.0, 0.0});
  bands.response.add({3.0, std::string("climb_mps"), 1.0, 0.5, 0.5});
  for (const Picture& p : collective_response(bands).pictures)
    CHECK_EQ(count(p.svg, "class=\"band\""), p.name == "response_climb" ? 1u : 0u);
}
