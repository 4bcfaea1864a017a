// Which field of a setup prepare() refuses, and its range: what first_out_of_range() says and prepare() does are one.
#include <limits>
#include <string>

#include "check.hpp"
#include "model/flight_cases.hpp"
#include "tiltrotor/model/setup/setup_explanation.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

using namespace tiltrotor;

namespace {

const Aircraft<double>& aircraft() { return flight_cases::aircraft(); }

void set(FlightSetup<double>& s, SetupField field, double value) {
  switch (field) {
    case SetupField::mast_deg:
      s.mast_deg = value;
      break;
    case SetupField::mast_rate:
      s.mast_rate = value;
      break;
    case SetupField::mast_acceleration:
      s.mast_acceleration = value;
      break;
    case SetupField::flap_deg:
      s.flap_deg = value;
      break;
    case SetupField::rotor_speed:
      s.rotor_speed = value;
      break;
    case SetupField::rotor_acceleration:
      s.rotor_acceleration = value;
      break;
    case SetupField::altitude:
      s.altitude = value;
      break;
    case SetupField::mass:
      s.mass = value;
      break;
    case SetupField::sl_cg:
      s.sl_cg = value;
      break;
    case SetupField::wl_cg:
      s.wl_cg = value;
      break;
    case SetupField::grid_refinement:
      s.options.grid_refinement = static_cast<int>(value);
      break;
    case SetupField::azimuth_stations:
      s.options.azimuth_stations = static_cast<int>(value);
      break;
    case SetupField::hub_spring_factor:
      s.options.hub_spring_factor = value;
      break;
    case SetupField::induced_power_factor:
      s.options.induced_power_factor = value;
      break;
    case SetupField::none:
    case SetupField::count:
      break;
  }
}

bool is_whole(SetupField field) {
  return field == SetupField::grid_refinement || field == SetupField::azimuth_stations;
}

template <class Visit>
void every_field(Visit&& visit) {
  for (unsigned k = 1; k < static_cast<unsigned>(SetupField::count); ++k) visit(static_cast<SetupField>(k));
}

}  // namespace

TEST(options_setup_names_the_field_out_of_range) {
  every_field([](SetupField field) {
    const Bounds<double> range = setup_range(aircraft(), field);
    CHECK_LT(range.low, range.high);
    const double beyond = is_whole(field) ? 1 : 1e-9 * (1 + std::fabs(range.high));
    const auto refused = [&](double value) {
      FlightSetup<double> setup = flight_setup(aircraft(), 30.0);
      set(setup, field, value);
      const SetupFault<double> fault = first_out_of_range(aircraft(), setup);
      Configuration<double> c;
      const Status status = prepare(aircraft(), setup, c);
      CHECK_EQ(status == Status::out_of_range, fault.field != SetupField::none);
      if (fault.field == SetupField::none) return false;
      CHECK(fault.field == field);
      CHECK_EQ(fault.range.low, range.low);
      CHECK_EQ(fault.range.high, range.high);
      CHECK(fault.value == value || std::isnan(value));
      return true;
    };
    CHECK(!refused(range.low));
    CHECK(!refused(range.high));
    CHECK(refused(range.low - beyond));
    CHECK(refused(range.high + beyond));
    if (!is_whole(field)) CHECK(refused(std::numeric_limits<double>::quiet_NaN()));
  });
}

TEST(options_setup_fault_is_one_line) {
  every_field([](SetupField field) {
    FlightSetup<double> setup = flight_setup(aircraft(), 30.0);
    set(setup, field, setup_range(aircraft(), field).high + 1);
    char text[80];
    const int length = explain(first_out_of_range(aircraft(), setup), text, sizeof text);
    const std::string line(text);
    CHECK_EQ(static_cast<std::size_t>(length), line.size());
    CHECK_LT(line.size(), sizeof text - 1);  // not cut
    CHECK(line.find(setup_field_name(field)) == 0);
    CHECK(line.find(" lies outside ") != std::string::npos && line.find('\n') == std::string::npos);
  });
  char text[4] = "abc";
  CHECK_EQ(explain(first_out_of_range(aircraft(), flight_setup(aircraft(), 0.0)), text, sizeof text), 0);
  CHECK_EQ(text[0], '\0');
}

TEST_OF_XV15(options_setup_fault_says_value_and_range) {
  FlightSetup<double> setup = flight_setup(aircraft(), 30.0);
  setup.mass = 2000;
  char text[80];
  (void)explain(first_out_of_range(aircraft(), setup), text, sizeof text);
  CHECK_EQ(std::string(text), std::string("mass 2000 kg lies outside 3000..10000 kg"));
  setup.options.azimuth_stations = 2;
  setup.mass = 5000;
  (void)explain(first_out_of_range(aircraft(), setup), text, sizeof text);
  CHECK_EQ(std::string(text), std::string("azimuth_stations 2 lies outside 0 or 3..72"));
}

// The default setup of every mast angle is inside all ranges; commands reach both stops.
TEST(options_default_setups_are_in_range) {
  for (double mast = 0; mast <= 90; mast += 15) {
    CHECK(first_out_of_range(aircraft(), flight_setup(aircraft(), mast)).field == SetupField::none);
  }
  const ControlTables<double>& t = aircraft().controls;
  CHECK_EQ(control_range(aircraft(), kControlIndex.long_stick).high, t.long_travel);
  CHECK_EQ(control_range(aircraft(), kControlIndex.lat_stick).low, -t.lat_travel);
  CHECK_EQ(control_range(aircraft(), kControlIndex.pedal).high, t.pedal_travel);
  for (int j = 0; j < control_count; ++j) {
    const Bounds<double> range = control_range(aircraft(), j);
    CHECK(range.low < 0 && range.high > 0);
  }
}
