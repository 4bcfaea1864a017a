// The landing gear on its way. Expected: a constant rate by hand, dynamic pressure times area, the gear that moved at once.
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

constexpr double kStep = 0.005;

// At 60 m/s in airplane mode, or hovering; the gear on, up.
Flight in_flight(double mast_deg, double speed) {
  SystemSwitches on = with(Governor::pi);
  on.gear = true;
  Flight f = begun(mast_deg, level(speed), on, kStep);
  f.vehicle().ground.down = f.s.state.position.z + 1000;
  return f;
}
int steps_of(double seconds) { return static_cast<int>(std::lround(seconds / kStep)); }
double transit() { return aircraft_data<double>().gear.transit; }

// Force of all that is not the airframe's, body axes.
Vec3<double> gear_force(const Flight& f) { return rates(f).demand.gear.total.force; }

}  // namespace

// t / T of it is out after t, all of it from T on, and back again.
TEST(gear_in_transit_moves_at_a_constant_rate) {
  Flight f = in_flight(90, 80);
  CHECK_EQ(f.state().gear, 0.0);
  f.vehicle().gear_down = true;
  for (const double part : {0.25, 0.5, 0.75}) {
    CHECK(fly(f, steps_of(transit() / 4)) == Status::ok);
    CHECK_NEAR(f.state().gear, part, 1.01 * kStep / transit());
    CHECK(!is_locked_down(f.vehicle(), f.state().gear));
  }
  CHECK(fly(f, steps_of(transit() / 4) + 2) == Status::ok);
  CHECK_EQ(f.state().gear, 1.0);
  CHECK(is_locked_down(f.vehicle(), f.state().gear));
  // Up again, and down before it has arrived.
  f.vehicle().gear_down = false;
  CHECK(!is_locked_down(f.vehicle(), f.state().gear));
  CHECK(fly(f, steps_of(transit() / 4)) == Status::ok);
  CHECK_NEAR(f.state().gear, 0.75, 1.01 * kStep / transit());
  f.vehicle().gear_down = true;
  CHECK(fly(f, steps_of(transit() / 4) + 2) == Status::ok);
  CHECK_EQ(f.state().gear, 1.0);
}

// The drag is that of the part that is out: q A times it, against the air.
TEST(gear_in_transit_has_the_drag_of_what_is_out) {
  Flight f = in_flight(90, 80);
  f.c.around.wind_n = {};
  for (const double part : {0.0, 0.3, 0.8, 1.0}) {
    f.state().gear = part;
    f.vehicle().gear_down = part > 0.5;  // told to or not, the air sees what is out
    const Vec3<double> found = gear_force(f), v = f.s.state.velocity;
    const double q = 0.5 * f.c.air.density * dot(v, v), area = f.c.aircraft->gear.drag_area;
    CHECK_NEAR(length(found), part * q * area, 1e-3 * q * area);
    CHECK_LE(dot(found, v), 0.0);
  }
  // Slower by it: m v' = -D.
  const double mass = f.c.mass.mass, before = rates(f).of[kStateIndex.velocity.x];
  const double drag = -gear_force(f).x;
  f.state().gear = 0;
  CHECK_NEAR(rates(f).of[kStateIndex.velocity.x] - before, drag / mass, 1e-3 * drag / mass);
  CHECK_LT(0.0, drag);
}

// Nothing of it carries before it is locked down, and nothing from the moment it is told to go up.
TEST(gear_in_transit_does_not_carry) {
  Flight f = in_flight(0, 0);
  f.vehicle().ground = {f.s.state.position.z + 1.5 * this_aircraft::length(), 0,
                        0};  // wheels some inches in it
  const auto carried = [&f](bool down, double part) {
    f.vehicle().gear_down = down;
    f.state().gear = part;
    return rates(f).demand.gear.weight_on_wheels;
  };
  CHECK_LT(0.2, carried(true, 1));
  CHECK_EQ(carried(true, 0.999), 0.0);
  CHECK_EQ(carried(false, 1), 0.0);
  CHECK_EQ(carried(false, 0), 0.0);
  CHECK_EQ(carried(true, 0), 0.0);
}

// It is moved between steps and held in them: the flight is that in which every step is begun by hand with t / T of it out.
TEST(gear_in_transit_is_held_in_a_step) {
  Flight f = in_flight(90, 80), by_hand = f, up = f;
  f.vehicle().gear_down = true;
  const int steps = 40;
  CHECK(fly(f, steps) == Status::ok && fly(up, steps) == Status::ok);
  for (int k = 0; k < steps; ++k) {
    by_hand.vehicle().gear_down = k % 2 == 0;  // whichever way it is told to go
    by_hand.state().gear = k * kStep / transit();
    CHECK(fly(by_hand, 1) == Status::ok);
  }
  by_hand.state().gear = f.state().gear;
  CHECK_LT(difference(f, by_hand), 1e-13);
  CHECK_LT(1e-7, difference(f, up));
}

// Where it is off it stays where it was told to be by nobody.
TEST(gear_in_transit_needs_its_system) {
  Flight f = begun(90, level(80), with(Governor::pi), kStep);
  f.vehicle().gear_down = true;
  CHECK(fly(f, 100) == Status::ok);
  CHECK_EQ(f.state().gear, 0.0);
  CHECK_EQ(gear_force(f).x, 0.0);
}
