// What figures and tables of the report are drawn from: published points where they belong, windows of the complex
// plane, limits, both linear models, slow flight in any direction.
// Expected: the printed tables, Newton's laws, algebra by hand.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "study/drawn_with.hpp"
#include "study/mode_speeds.hpp"
#include "study/mode_table.hpp"
#include "study/printed_flights.hpp"
#include "study/printed_linear_model.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/sideward_flight.hpp"
#include "study/transfer_function.hpp"

using tiltrotor::aircraft_data;
using tiltrotor::dot;
using tiltrotor::Evaluation;
using tiltrotor::InflowShape;
using tiltrotor::kInceptors;
using tiltrotor::kPi;
using tiltrotor::kStateIndex;
using tiltrotor::ModeKind;
using tiltrotor::Vec3;
using namespace tiltrotor::study;
namespace study = tiltrotor::study;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

const Table& table_of(const Section& section, const std::string& name) {
  for (const NumberedTable& t : section.tables)
    if (t.name == name) return t.table;
  throw std::logic_error("no table " + name);
}

const std::string& svg_of(const std::vector<Picture>& pictures, const std::string& name) {
  for (const Picture& p : pictures)
    if (p.name == name) return p.svg;
  throw std::logic_error("no picture " + name);
}

// A table of modes with two branches at two mast angles.
Table some_modes() {
  Table table = mode_table({"mast_deg", "speed_mps"});
  const auto add = [&](double mast, double speed, const char* axis, const char* mode, double re, double im,
                       double branch) {
    const double frequency = std::hypot(re, im);
    table.add(
        {mast, speed, std::string(axis), std::string(mode), re, im, frequency, -re / frequency, 1.0, branch});
  };
  for (const double speed : {60.0, 70.0, 80.0}) {
    add(90, speed, "longitudinal", "short_period", -1.5, 2, 0);
    add(90, speed, "longitudinal", "phugoid", -0.1, 0.3, 1);
  }
  add(0, 0, "longitudinal", "phugoid", 0.2, 0.4, 0);
  add(0, 10, "longitudinal", "heave", -5, 0, 0);
  return table;
}

}  // namespace

// Under each figure: aircraft, governor, inflow.
TEST(report_figures_say_with_what_they_are_drawn) {
  Setup setup = default_setup(0);
  setup.mass = 5000;
  setup.altitude = 2438;
  setup.options.inflow = InflowShape::uniform;
  const std::string words = drawn_with(ComparedAircraft::as_flown, setup);
  for (const char* part :
       {"Aircraft: ", "as flown", "11023 lb", "2438 m", "Governor: none", "Inflow: uniform"}) {
    if (!CHECK(contains(words, part))) NOTE(part);
  }
  CHECK(contains(drawn_with(), "sea level") && contains(drawn_with(), "Inflow: Pitt-Peters"));
  CHECK(contains(drawn_with_rotor_alone(), "one rotor"));
}

// Every printed trim of its mast angle stands in the figures of pitch, flapping and loads of components.
TEST_OF_XV15(report_trim_figures_carry_the_printed_points) {
  Sweeps sweeps;
  for (const double mast : {0.0, 15.0, 30.0, 60.0, 90.0}) sweeps.push_back(speed_sweep(mast, 10, 140));
  const Section section = trim_curves(sweeps);
  const std::size_t trims = reference_points("trim_gtrs_conversion").rows();
  const auto marks = [&](const char* name) {
    const std::string& text = svg_of(section.pictures, name);
    return count(text, "l7.2 0l0 7.2");  // a square of half width 4, 0.9 of it
  };
  const std::size_t key = 1;
  CHECK_EQ(marks("trim_pitch"), trims + reference_points("trim_gtrs_printed").rows() + key);
  CHECK_EQ(marks("trim_power"), reference_points("rotor_power_gtrs").rows() + key);
  for (const char* name : {"trim_long_flap", "trim_lat_flap", "trim_collective"})
    CHECK_EQ(marks(name), trims + reference_points("flapping_gtrs").rows() + key);
  CHECK_EQ(marks("trim_wing_z"), trims + key);
  CHECK_EQ(marks("trim_airframe_x"), trims + key);
  const std::size_t helicopter =
      reference_points("component_loads_gtrs").where("component", std::string("horizontal_tail")).rows();
  CHECK_EQ(marks("trim_tail_z"), trims + helicopter + key);
  for (const Picture& p : section.pictures)
    CHECK(contains(p.svg, "Aircraft: ") && contains(p.svg, "Governor: ") && contains(p.svg, "Inflow: "));
}

// Around given roots, at least as wide as high, the origin inside.
TEST(report_windows_of_the_complex_plane) {
  const Table modes = some_modes();
  const PlaneWindow whole = window_around(modes, "", -3);
  CHECK(whole.left < -1.5 && whole.left > -3 && whole.right > 0.2 && whole.top > 2 && whole.top < 2.4);
  const PlaneWindow slow = window_around(modes, "phugoid", -3);
  CHECK(slow.left < -0.1 && slow.right > 0.2 && slow.top > 0.4 && slow.top < 0.5);
  for (const PlaneWindow& w : {whole, slow}) CHECK(w.right - w.left >= w.top);
}

// A limit of airplane mode runs over the speeds of airplane mode; of two levels the second is dotted. The
// published values are those of the standards: a time constant of 1.4 s, a time to double of 20 s.
TEST_OF_XV15(report_mode_figures_carry_limits) {
  const Table limits = reference_points("handling_limits");
  const auto level_1 = [&](const char* mode) {
    return limits.where("mode", std::string(mode)).where("label", std::string("8785C level 1"));
  };
  CHECK_NEAR(level_1("roll").number(0, "value"), -1 / 1.4, 1e-3);
  CHECK_NEAR(level_1("spiral").number(0, "value"), std::log(2.0) / 20, 1e-4);
  const std::vector<Picture> pictures = mode_speed_pictures(some_modes());
  CHECK_EQ(pictures.size(), std::size_t{8});
  const std::string& damping = svg_of(pictures, "mode_speed_short_period_damping");
  CHECK(contains(damping, "1797A level 1") && contains(damping, "1797A level 2"));
  CHECK(contains(damping, "stroke-dasharray=\"7 4\"") && contains(damping, "stroke-dasharray=\"2 3\""));
  CHECK(!contains(svg_of(pictures, "mode_speed_short_period_frequency"), "1797A"));
  CHECK(contains(svg_of(pictures, "mode_speed_phugoid_damping"), "AGARD level 1"));
}

// The wing is one curve: of its parts in the wakes and outside only the sum is physics.
TEST(report_draws_the_wing_as_a_whole) {
  Sweeps sweeps;
  for (const double mast : {0.0, 30.0, 60.0}) sweeps.push_back(speed_sweep(mast, 20, 60));
  for (const Picture& p : load_sharing(sweeps).pictures) {
    CHECK_EQ(count(p.svg, ">wing</text>"), std::size_t{1});
    CHECK(!contains(p.svg, "wake"));
  }
}

// At 200 kt: every printed term has its own, an explanation where it is outside 15 % and none where it is not, which
// says whether it is known.
TEST_OF_XV15(report_linear_models_stand_side_by_side) {
  const Section section = linear_matrices();
  const Table& terms = table_of(section, "linear_200kt_terms");
  const Table printed = reference_points("linear_model_gtrs");
  if (!CHECK_EQ(terms.rows(), printed.rows())) return;
  for (std::size_t i = 0; i < terms.rows(); ++i) {
    CHECK_NEAR(terms.number(i, "printed"), printed.number(i, "value"), 5e-5);
    CHECK_NEAR(terms.number(i, "ratio"), terms.number(i, "here") / terms.number(i, "printed"),
               1e-3 + 1e-4 / std::fabs(terms.number(i, "printed")));
    const bool outside = std::fabs(terms.number(i, "ratio") - 1) > 0.15;
    const std::string& why = terms.text(i, "explanation");
    if (!CHECK_EQ(outside, contains(why, "nown")))
      NOTE(terms.text(i, "row") << " " << terms.text(i, "column"));
  }
  std::size_t shown = 0;
  for (const char* axis : {"longitudinal", "lateral"}) {
    const Table& matrix = table_of(section, std::string("linear_200kt_") + axis);
    CHECK_EQ(matrix.columns().size(), std::size_t{13});
    for (std::size_t i = 0; i < matrix.rows(); ++i) {
      for (std::size_t j = 1; j <= 6; ++j) {
        CHECK_EQ(matrix.text(i, j).empty(), matrix.text(i, j + 6).empty());
        shown += !matrix.text(i, j).empty();
      }
    }
  }
  CHECK_EQ(shown, printed.rows());
}

// The delay to first order shifts the short period as the option that takes the downwash at once does in the complete
// model; speed and roll, which the tail does not feel, stay as they are.
TEST_OF_XV15(report_delay_of_the_downwash_acts_as_in_the_complete_model) {
  Setup setup = printed_model_setup(ComparedAircraft::as_simulated);
  const auto damping = [](const Linear& m) {
    const Modes modes = modes_of(m);
    for (int k = 0; k < modes.count; ++k)
      if (modes.mode[k].label.kind == ModeKind::short_period) return modes.mode[k].real;
    return 0.0;
  };
  const Linear late = printed_states(setup, aircraft_data<double>(), DownwashDelay::first_order);
  const Linear at_once = printed_states(setup, aircraft_data<double>(), DownwashDelay::none);
  const double complete_late = damping(linear_model_at(setup, 200 * study::kKnot, kInceptors));
  setup.options.downwash_lag = false;
  const double complete_at_once = damping(linear_model_at(setup, 200 * study::kKnot, kInceptors));
  CHECK_LT(complete_late - complete_at_once, -0.1);
  CHECK_REL(damping(late) - damping(at_once), complete_late - complete_at_once, 0.25);
  const auto term = [](const Linear& m, int row, int column) { return state_derivative(m, row, column); };
  CHECK_REL(term(late, kStateIndex.velocity.x, kStateIndex.velocity.x),
            term(at_once, kStateIndex.velocity.x, kStateIndex.velocity.x), 2e-3);
  CHECK_EQ(term(late, kStateIndex.rates.x, kStateIndex.rates.x),
           term(at_once, kStateIndex.rates.x, kStateIndex.rates.x));
}

// Newton's laws at 25 kt to each side and backwards; mirrored flights are mirrored; ahead it is the trim.
TEST(report_sideward_flight_is_steady) {
  const Configured c = configured(0);
  const double speed = 25 * study::kKnot;
  const double right_angle = 0.5 * kPi<double>;
  for (const double track : {right_angle, -right_angle, 2 * right_angle}) {
    const SidewardFlight f = sideward_flight(c, speed, track);
    if (!CHECK(f.found)) continue;
    const Evaluation<double> e = evaluated(c, f.state, f.controls);
    CHECK_LT(std::fabs(e.rates.velocity.x) + std::fabs(e.rates.velocity.y) + std::fabs(e.rates.velocity.z),
             1e-7);
    CHECK_LT(std::fabs(e.rates.rates.x) + std::fabs(e.rates.rates.y) + std::fabs(e.rates.rates.z), 1e-7);
    const Vec3<double>& v = f.state.velocity;
    CHECK_NEAR(std::sqrt(dot(v, v)), speed, 1e-9);
    CHECK_LT(travel_used(c, f.controls), 1.0);
  }
  const SidewardFlight to_right = sideward_flight(c, speed, right_angle);
  const SidewardFlight to_left = sideward_flight(c, speed, -right_angle);
  CHECK(to_right.state.roll > 0.01);
  CHECK_NEAR(to_right.state.roll, -to_left.state.roll, 1e-6);
  CHECK_NEAR(to_right.controls.pedal, -to_left.controls.pedal, 1e-6);
  const SidewardFlight ahead = sideward_flight(c, speed, 0);
  const Trimmed trim = trimmed_persistently(c, speed);
  CHECK_NEAR(ahead.state.pitch, trim.state.pitch, 1e-6);
  CHECK_NEAR(ahead.controls.long_stick, trim.controls.long_stick, 1e-6);
}

TEST(report_leading_coefficient) {
  CHECK_EQ(leading_coefficient("-7.38 -6.5682"), -7.38);
  CHECK_EQ(leading_coefficient("2"), 2.0);
}
