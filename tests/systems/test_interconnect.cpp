// The shaft between the rotors, where it twists: against two bodies on a spring, energy, and the printed mode of the drive.
#include "tiltrotor/math/algebra/eigen.hpp"
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

const Aircraft<double>& aircraft() { return aircraft_data<double>(); }
double stiffness() { return aircraft().systems.drive.interconnect_stiffness; }
double rotor() { return aircraft().rotor.blades * aircraft().rotor.flap_inertia; }
double half(bool runs) { return rotor() + (runs ? aircraft().systems.drive.turbine_inertia : 0); }

SystemSwitches twisting(bool engines = false) {
  SystemSwitches on{};
  on.governor = Governor::pi;
  on.engines = engines;
  on.interconnect = true;
  return on;
}

double speed_of(const Flight& f, Side side) {
  return f.state().rotor_speed + (side == right ? 0.5 : -0.5) * f.state().twist_rate;
}

}  // namespace

// Two bodies on a spring: the mean speeds up as with a rigid shaft while both engines run, the difference as
// J (Omega_R' - Omega_L') = eta (P_R/Omega_R - P_L/Omega_L) - Q_R + Q_L - 2 k tau.
TEST(interconnect_halves_are_two_bodies_on_a_spring) {
  for (const double mast : {0.0, 40.0, 90.0}) {
    Flight f = begun(mast, level(20 + 0.8 * mast), twisting());
    f.vehicle().commands.throttle[right] *= 1.2;
    f.state().shaft_twist += 0.003;
    const double omega = f.state().rotor_speed, efficiency = aircraft().controls.transmission_efficiency;
    const Rates twists = rates(f);
    f.vehicle().on.interconnect = false;
    CHECK_REL(twists.of_system(kSystemIndex.rotor_speed), rates(f).of_system(kSystemIndex.rotor_speed), 1e-9);
    double power[2];
    for (const Side side : {right, left})
      power[side] = demanded_power(aircraft(), f.c.air, f.vehicle().commands.throttle[side]);
    const double torque[] = {twists.airframe.torque[right], twists.airframe.torque[left]};
    const double wanted = efficiency * (power[right] - power[left]) / omega - torque[right] + torque[left] -
                          2 * stiffness() * f.state().shaft_twist;
    CHECK_REL(half(true) * twists.of_system(kSystemIndex.twist_rate), wanted, 1e-9);
    CHECK_EQ(twists.of_system(kSystemIndex.shaft_twist), f.state().twist_rate);
  }
}

// With a rotor faster than the other, each has the torque that both have at its speed.
TEST(interconnect_rotors_feel_their_own_speed) {
  Flight f = begun(20, level(45), twisting());
  f.state().twist_rate = 1.4;
  const Rates apart = rates(f);
  f.state().twist_rate = 0;
  const double mean = f.state().rotor_speed;
  for (const Side side : {right, left}) {
    f.state().rotor_speed = mean + (side == right ? 0.7 : -0.7);
    CHECK_REL(apart.airframe.torque[side], rates(f).airframe.torque[side], 1e-12);
  }
  CHECK_LT(1.0, std::fabs(apart.airframe.torque[right] - apart.airframe.torque[left]));
}

// What speeds the rotors up against each other turns the airframe the other way: the moments at the hubs, by hub_loads().
TEST(interconnect_reaction_is_that_of_the_hubs) {
  for (const double mast : {0.0, 35.0, 90.0}) {
    Flight f = begun(mast, level(20 + 0.8 * mast), twisting());
    const Rates before = rates(f);
    f.state().shaft_twist += 0.004;
    const Rates after = rates(f);
    const double apart = after.of_system(kSystemIndex.twist_rate) - before.of_system(kSystemIndex.twist_rate);
    CHECK_REL(apart, -2 * stiffness() * 0.004 / half(true), 1e-9);
    Configuration<double> c = f.c;
    Vec3<double> wanted{};
    for (const Side side : {right, left}) {
      c.rotor[side].spin_up = (side == right ? 0.5 : -0.5) * rotor() * apart;
      wanted = wanted + hub_loads(c, side, RotorState<double>{}, RotorLoads<double>{}).moment;
    }
    const Inertia<double>& i = f.c.mass.inertia;
    const double p = after.of[kStateIndex.rates.x] - before.of[kStateIndex.rates.x];
    const double q = after.of[kStateIndex.rates.y] - before.of[kStateIndex.rates.y];
    const double r = after.of[kStateIndex.rates.z] - before.of[kStateIndex.rates.z];
    const double size = rotor() * std::fabs(apart);
    CHECK_NEAR(i.xx * p - i.xz * r, wanted.x, 1e-9 * size);
    CHECK_NEAR(i.yy * q, 0, 1e-9 * size);
    CHECK_NEAR(i.zz * r - i.xz * p, wanted.z, 1e-9 * size);
    CHECK_LT(0.99 * size, std::hypot(wanted.x, wanted.z));
  }
}

// The first antisymmetric mode of the drive: 0.39 per rev at 565 rpm, 0.48 at 458 (TM X-62407 fig. 7.1.3). The air damps
// it and shifts it a little.
TEST_OF_XV15(interconnect_has_the_printed_mode) {
  struct Case {
    double mast, speed, rpm, per_rev;
  };
  for (const Case& at : {Case{0, 0, 565, 0.39}, Case{90, 90, 458, 0.48}}) {
    const double printed = at.per_rev * at.rpm * kPi<double> / 30;
    CHECK_REL(std::sqrt(2 * stiffness() / half(true)), printed, 0.005);
    const Flight f = begun(at.mast, level(at.speed), twisting());
    const Matrices& m = matrices(f);
    static Matrix<double, kMaxVehicleStates, kMaxVehicleStates> a;
    static EigenWorkspace<double, kMaxVehicleStates> work;
    const int n = m.shape.states;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) a(i, j) = m.a[i][j];
    Eigenvalues<double, kMaxVehicleStates> values;
    CHECK(eigenvalues(a, n, work, values) == Status::ok);
    double nearest = 1e9, damping = 0;
    for (int i = 0; i < n; ++i) {
      const double size = std::hypot(values.real[i], values.imag[i]);
      if (values.imag[i] <= 0 || std::fabs(size - printed) > std::fabs(nearest - printed)) continue;
      nearest = size;
      damping = -values.real[i] / size;
    }
    NOTE("mast " << at.mast << ": " << nearest << " rad/s, damping " << damping << ", printed " << printed);
    CHECK_REL(nearest, printed, 0.05);
    CHECK_LT(0, damping);
    CHECK_LT(damping, 0.2);
  }
}

// An engine that fails leaves its half to the shaft: it swings with k (1/J_R + 1/J_L), about the torque that takes half the
// power across, of one engine or of none.
TEST(interconnect_carries_the_other_engine) {
  Flight f = begun(0, level(30), twisting(), 0.0025, Integrator::rk4);
  CHECK_NEAR(f.state().shaft_twist, 0, 1e-6);
  const double omega = f.state().rotor_speed;
  const double half_torque = 0.5 * (rates(f).airframe.torque[right] + rates(f).airframe.torque[left]);
  f.vehicle().commands.throttle[right] *= 2;
  f.vehicle().engine_failed[left] = true;
  const double frequency = std::sqrt(stiffness() * (1 / half(true) + 1 / half(false)));
  const int steps = static_cast<int>(std::lround(5 * 2 * kPi<double> / frequency / 0.0025));
  double sum = 0, most = 0, last = 0, first_crossing = -1, crossing = -1;
  int crossings = 0;
  const double mean = half_torque / stiffness();
  for (int k = 0; k < steps; ++k) {
    CHECK(fly(f, 1) == Status::ok);
    const double away = f.state().shaft_twist - mean;
    if (k > 0 && (away > 0) != (last > 0)) {
      crossing = (k + last / (last - away)) * 0.0025;
      if (crossings++ == 0) first_crossing = crossing;
    }
    last = away;
    sum += f.state().shaft_twist;
    most = std::max(most, f.state().shaft_twist);
  }
  const double found = kPi<double> * (crossings - 1) / (crossing - first_crossing);
  NOTE("twist " << sum / steps / kDeg << " deg in the mean, at most " << most / kDeg << "; " << found
                << " rad/s, two bodies " << frequency << "; rotor speed " << f.state().rotor_speed / omega);
  CHECK_REL(found, frequency, 0.03);
  CHECK_REL(sum / steps, mean, 0.1);
  CHECK_LT(1.5 * mean, most);
  CHECK_LT(most, 2.1 * mean);
}

// Energy of both halves and of the shaft is what engines gave and rotors did not take. Simpson's rule over the steps.
TEST(interconnect_energy_is_kept_in_flight) {
  Flight f = begun(30, level(50), twisting(true), 0.0025, Integrator::rk4);
  f.vehicle().commands.throttle[right] *= 1.5;
  f.vehicle().commands.throttle[left] *= 0.7;
  f.state().shaft_twist += 0.02;
  const double efficiency = aircraft().controls.transmission_efficiency;
  const auto surplus = [&] {
    const Rates r = rates(f);
    double sum = efficiency * (f.state().power[right] + f.state().power[left]);
    for (const Side side : {right, left}) sum -= r.airframe.torque[side] * speed_of(f, side);
    return sum;
  };
  const auto energy = [&] {
    return 0.5 * half(true) * (square(speed_of(f, right)) + square(speed_of(f, left))) +
           0.5 * stiffness() * square(f.state().shaft_twist);
  };
  const double before = energy();
  double given = 0, largest = 0;
  for (int k = 0; k < 200; ++k) {
    const double begin = surplus();
    CHECK(fly(f, 1) == Status::ok);
    const double middle = surplus();
    CHECK(fly(f, 1) == Status::ok);
    given += 0.005 / 6 * (begin + 4 * middle + surplus());
    largest = std::max(largest, std::fabs(energy() - before));
  }
  NOTE("given " << given << " J, gained " << energy() - before << " J, at most " << largest << " J");
  CHECK_NEAR(energy() - before, given, 1e-4 * largest);
}

// One engine out, settled: nothing moves, and the shaft carries half of what the rotors take.
TEST(interconnect_is_at_rest_in_a_steady_flight) {
  Flight f = begun(0, level(40), twisting());
  f.vehicle().engine_failed[right] = true;
  const Rates r = rates(f);
  Controls<double> u = current_controls(f.s);
  settle(f.c, f.s.state, {r.airframe.torque[right], r.airframe.torque[left]}, f.vehicle(), f.state(), u);
  CHECK_REL(f.state().shaft_twist * stiffness(), -r.airframe.torque[right], 1e-9);
  const Rates at_rest = rates(f);
  // The smooth clip of the throttle takes a part of 1e-7 of the power.
  CHECK_NEAR(at_rest.of_system(kSystemIndex.twist_rate), 0, 1e-4);
  CHECK_NEAR(at_rest.of_system(kSystemIndex.rotor_speed), 0, 1e-4);
}

// Without its switch, or with a governor that has no rotor speed, states of the shaft are not read.
TEST(interconnect_that_is_rigid_has_no_states) {
  Flight f = begun(30, level(50), twisting());
  f.vehicle().on.interconnect = false;
  const Rates before = rates(f);
  f.state().shaft_twist = 0.1;
  f.state().twist_rate = 3;
  const Rates after = rates(f);
  for (int i = 0; i < vehicle_state_count; ++i) CHECK_EQ(after.of[i], before.of[i]);
  f.c.setup.rotor_difference = 1;  // left by a flight whose shaft twisted
  configure(f.c);
  const Rates rigid = rates(f);
  for (int i = 0; i < vehicle_state_count; ++i) CHECK_EQ(rigid.of[i], before.of[i]);
  SystemSwitches on = twisting();
  CHECK(is_active(kSystemIndex.shaft_twist, on) && is_active(kSystemIndex.twist_rate, on));
  for (const Governor governor : {Governor::off, Governor::ideal}) {
    on.governor = governor;
    CHECK(!is_active(kSystemIndex.shaft_twist, on) && !is_active(kSystemIndex.twist_rate, on));
  }
}
