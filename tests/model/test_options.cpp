// Every switch of the model changes what it says and no other bit: parts of an evaluation that change are listed for each.
#include "flight_cases.hpp"
#include "tiltrotor/model/variables/presets.hpp"

using namespace flight_cases;

namespace {

// Parts of an evaluation.
enum Part : unsigned {
  rotor_forces = 1u << 0,  // sums over the blades
  tilt = 1u << 1,          // rates of the flap states
  mean_inflow = 1u << 2,
  cyclic_inflow = 1u << 3,
  coning_rates = 1u << 4,
  hub_component = 1u << 5,  // loads of the rotors on the airframe
  wing_in_rotor_wake = 1u << 6,
  wing_in_free_stream = 1u << 7,
  pylon_interference = 1u << 8,
  spinner_drag = 1u << 9,
  side_plates = 1u << 10,
  body = 1u << 11,
  tailplane = 1u << 12,
  fins = 1u << 13,
  lagged_downwash = 1u << 14,
  angular_acceleration = 1u << 15,
  jets = 1u << 16,
};
// Blade loads reach the free wing's flow through the rotor force.
constexpr unsigned kBladeLoads = rotor_forces | tilt | mean_inflow | cyclic_inflow | hub_component |
                                 wing_in_free_stream | lagged_downwash | angular_acceleration;

struct Condition {
  double mast = 30;
  unsigned seed = 3;
};

StateAndControls<double> state(const Condition& k, const Options& options) {
  Generator random(k.seed);
  StateAndControls<double> s = random_case(random, configuration(k.mast, options));
  // Inside the fade of the wake, faster than the advance of the lateral cyclic schedule, with sideslip.
  s.x.velocity = {16, 3, 1};
  if (k.mast >= 90) s.x.velocity = {80, 5, 3};
  if (k.mast >= 45 && k.mast < 90) s.x.velocity = {50, 5, 3};
  s.u.gust = {0, 0, 0};
  return s;
}

Evaluation<double> evaluated(const Condition& k, const Options& options) {
  const StateAndControls<double> s = state(k, Options{});
  Evaluation<double> out;
  evaluate_aircraft(configuration(k.mast, options), s.x, s.u, out);
  return out;
}

template <class S>
bool same(const S& a, const S& b) {
  return flat(a) == flat(b);
}

unsigned changed(const Evaluation<double>& a, const Evaluation<double>& b) {
  unsigned parts = 0;
  const auto mark = [&](bool equal, unsigned part) { parts |= equal ? 0 : part; };
  for (const int side : {right, left}) {
    const MastLoads<double>& p = a.rotor[side].loads;
    const MastLoads<double>& q = b.rotor[side].loads;
    mark(p.force_a.x == q.force_a.x && p.force_a.y == q.force_a.y && p.force_a.z == q.force_a.z &&
             p.torque == q.torque,
         rotor_forces);
    const RotorState<double>& x = a.rates.rotor[side];
    const RotorState<double>& y = b.rates.rotor[side];
    mark(x.b1c == y.b1c && x.b1s == y.b1s && x.b1c_rate == y.b1c_rate && x.b1s_rate == y.b1s_rate, tilt);
    mark(x.lambda_0 == y.lambda_0, mean_inflow);
    mark(x.lambda_c == y.lambda_c && x.lambda_s == y.lambda_s, cyclic_inflow);
    mark(a.rates.coning[side].angle == b.rates.coning[side].angle &&
             a.rates.coning[side].rate == b.rates.coning[side].rate,
         coning_rates);
  }
  const auto component = [&](Component k, unsigned part) { mark(same(a.loads[k], b.loads[k]), part); };
  component(Component::rotor_right, hub_component);
  component(Component::rotor_left, hub_component);
  component(Component::wing_wake_right, wing_in_rotor_wake);
  component(Component::wing_wake_left, wing_in_rotor_wake);
  component(Component::wing_free, wing_in_free_stream);
  component(Component::pylon, pylon_interference);
  component(Component::spinners, spinner_drag);
  component(Component::pylon_side, side_plates);
  component(Component::fuselage, body);
  component(Component::htail, tailplane);
  component(Component::fin_right, fins);
  component(Component::fin_left, fins);
  component(Component::engine_jets, jets);
  mark(a.rates.downwash == b.rates.downwash, lagged_downwash);
  mark(a.rates.rates.x == b.rates.rates.x && a.rates.rates.y == b.rates.rates.y &&
           a.rates.rates.z == b.rates.rates.z,
       angular_acceleration);
  return parts;
}

// `must` change, `may` change, nothing else.
template <class Set>
void check_switch(const Condition& k, unsigned must, Set&& set, unsigned may = 0) {
  Options options;
  set(options);
  const unsigned parts = changed(evaluated(k, Options{}), evaluated(k, options));
  CHECK_EQ(parts & must, must);
  CHECK_EQ(parts & ~(must | may), 0u);
}

constexpr unsigned kAcceleration = angular_acceleration;

}  // namespace

TEST(options_defaults_are_the_first_choices) {
  // A default evaluation equals itself, and tables are C1: the comparison below is not blind.
  CHECK_EQ(changed(evaluated({}, Options{}), evaluated({}, Options{})), 0u);
  check_switch(
      {}, kBladeLoads | body | tailplane | fins, [](Options& o) { o.tables = Interpolation::linear; },
      wing_in_rotor_wake | pylon_interference | side_plates);
}

TEST(options_of_the_rotor) {
  check_switch({}, kBladeLoads, [](Options& o) { o.grid = BladeGrid::realtime; });
  check_switch({}, kBladeLoads, [](Options& o) { o.grid_refinement = 2; });
  check_switch({}, kBladeLoads, [](Options& o) { o.azimuth_stations = 9; });
  check_switch({}, kBladeLoads, [](Options& o) { o.azimuth = AzimuthMode::individual; });
  check_switch({}, kBladeLoads, [](Options& o) { o.flapping = FlapOrder::first; });
  check_switch({}, kBladeLoads, [](Options& o) { o.chord = ChordSource::text; });
  check_switch({}, kBladeLoads, [](Options& o) { o.chord = ChordSource::camrad; });
  check_switch({}, kBladeLoads, [](Options& o) { o.stall_delay = true; });
  check_switch({}, kBladeLoads, [](Options& o) { o.twist = TwistSource::linear; });
  check_switch({}, kBladeLoads | coning_rates, [](Options& o) { o.coning_states = true; });
  check_switch(
      {}, kBladeLoads, [](Options& o) { o.mast_cant = false; },
      wing_in_rotor_wake | pylon_interference | spinner_drag);
  check_switch({}, tilt | hub_component | kAcceleration, [](Options& o) { o.hub_spring_factor = 1.5; });
}

TEST(options_of_the_inflow) {
  check_switch({}, mean_inflow | cyclic_inflow, [](Options& o) { o.inflow = InflowShape::uniform; });
  check_switch({}, kBladeLoads, [](Options& o) { o.radial_inflow = RadialInflow::constant; });
  check_switch({}, mean_inflow | cyclic_inflow,
               [](Options& o) { o.inflow_gradient = InflowGradient::coleman; });
  check_switch({}, mean_inflow | cyclic_inflow,
               [](Options& o) { o.inflow_gradient = InflowGradient::white_blake; });
  check_switch({}, mean_inflow, [](Options& o) { o.apparent_mass = ApparentMass::loaded; });
  check_switch({}, mean_inflow | cyclic_inflow, [](Options& o) { o.disk_plane_inflow = true; });
  check_switch({}, mean_inflow | cyclic_inflow, [](Options& o) { o.induced_power_factor = 1.1; });
  check_switch({0}, mean_inflow, [](Options& o) { o.side_by_side = true; });
  check_switch({0}, mean_inflow, [](Options& o) { o.sideward_flight = true; });
}

// Outside vertical descent the switch changes nothing, in it the inflow alone.
TEST(options_descent_inflow_acts_in_descent_alone) {
  const auto alone = [](Options& o) { o.descent_inflow = DescentInflow::momentum; };
  for (const double mast : {0.0, 30.0, 90.0}) check_switch({mast}, 0, alone);
  Options momentum;
  alone(momentum);
  StateAndControls<double> s = state({0}, Options{});
  s.x.velocity = {1, 0, 12};
  s.x.rates = {0, 0, 0};
  for (const int side : {right, left}) s.x.rotor[side].lambda_0 = 0.1;
  Evaluation<double> a;
  Evaluation<double> b;
  evaluate_aircraft(configuration(0), s.x, s.u, a);
  evaluate_aircraft(configuration(0, momentum), s.x, s.u, b);
  CHECK_EQ(changed(a, b), static_cast<unsigned>(mean_inflow | cyclic_inflow));
}

TEST(options_of_the_wing) {
  check_switch(
      {0}, wing_in_rotor_wake | wing_in_free_stream | kAcceleration,
      [](Options& o) { o.wake = WakeModel::gtrs_empirical; }, pylon_interference);
  check_switch({0}, wing_in_rotor_wake | wing_in_free_stream | kAcceleration,
               [](Options& o) { o.wake_fade = false; });
  check_switch({0}, wing_in_rotor_wake | pylon_interference | wing_in_free_stream | kAcceleration,
               [](Options& o) { o.wash = WashFactor::vortex_cylinder; });
  check_switch({0}, wing_in_rotor_wake | kAcceleration,
               [](Options& o) { o.wake_load = WakeLoadFactor::gtrs; });
  check_switch(
      {60}, wing_in_free_stream | kAcceleration, [](Options& o) { o.mast_drag = MastDrag::linear; },
      wing_in_rotor_wake);
  for (const double mast : {0.0, 90.0})
    check_switch({mast}, 0, [](Options& o) { o.mast_drag = MastDrag::linear; });
  check_switch(
      {60}, wing_in_free_stream | kAcceleration, [](Options& o) { o.mast_drag = MastDrag::cross_flow; },
      wing_in_rotor_wake);
  check_switch({90}, wing_in_rotor_wake | wing_in_free_stream | kAcceleration,
               [](Options& o) { o.wake_fade_airplane = false; });
  check_switch({60}, 0, [](Options& o) { o.wake_fade_airplane = false; });
  check_switch({0}, 0, [](Options& o) { o.rotor_lift_flaps = RotorLiftFlaps::any; });
  check_switch({60}, wing_in_free_stream | kAcceleration,
               [](Options& o) { o.rotor_lift_flaps = RotorLiftFlaps::any; });
  check_switch({0}, wing_in_free_stream | kAcceleration, [](Options& o) { o.rotor_lift_on_wing = false; });
  check_switch(
      {90}, 0, [](Options& o) { o.rotor_lift_on_wing = false; }, wing_in_free_stream | kAcceleration);
  check_switch({0}, wing_in_free_stream | lagged_downwash | kAcceleration,
               [](Options& o) { o.wing_rate_velocity = true; });
}

TEST(options_of_the_tail) {
  check_switch({}, tailplane | lagged_downwash | kAcceleration, [](Options& o) { o.downwash_lag = false; });
  check_switch({}, tailplane | fins | kAcceleration, [](Options& o) { o.tail_wash = TailWash::closed_form; });
  check_switch({}, tailplane | kAcceleration, [](Options& o) { o.tail_pressure = TailPressure::constant; });
  check_switch({}, tailplane | kAcceleration, [](Options& o) { o.tail_pressure = TailPressure::by_mast; });
  check_switch({0}, 0, [](Options& o) { o.tail_pressure = TailPressure::by_mast; });
  check_switch({}, tailplane | fins | kAcceleration, [](Options& o) { o.tail_sideslip_loss = true; });
  check_switch({}, fins | kAcceleration, [](Options& o) { o.fin_area = FinArea::report; });
  check_switch({}, tailplane | kAcceleration,
               [](Options& o) { o.elevator_gearing = ElevatorGearing::printed_runs; });
}

TEST(options_of_mass_controls_and_states) {
  check_switch({}, kAcceleration, [](Options& o) { o.inertia = InertiaSet::design_1975; });
  check_switch({}, kAcceleration, [](Options& o) { o.inertia = InertiaSet::flown; });
  check_switch({0}, 0, [](Options& o) { o.nacelle_mass = NacelleMass::quoted; });
  check_switch({90}, kBladeLoads, [](Options& o) { o.cyclic_rigging = false; });
  check_switch({0}, 0, [](Options& o) { o.cyclic_rigging = false; });
  check_switch({}, tilt, [](Options& o) { o.flap_angular_acceleration = true; });
  check_switch({}, 0, [](Options& o) { o.position_states = true; });
  check_switch({}, 0, [](Options& o) { o.governor = Governor::pi; });
  check_switch({}, 0, [](Options& o) { o.interconnect = Interconnect::twists; });
  check_switch({}, jets | kAcceleration, [](Options& o) { o.engine_jets = true; });
  check_switch({0}, kBladeLoads, [](Options& o) { o.lateral_cyclic = true; });
}

TEST(options_sizes_in_closed_form) {
  const auto with = [](const Condition& k, auto&& set) {
    Options options;
    set(options);
    return evaluated(k, options);
  };
  const Condition helicopter{0};
  const Evaluation<double> base = evaluated(helicopter, Options{});
  // K_FW = 1.4 - 0.0035 x 40 deg against 1.07.
  const Evaluation<double> load = with(helicopter, [](Options& o) { o.wake_load = WakeLoadFactor::gtrs; });
  CHECK_REL(load.loads[Component::wing_wake_right].force.z / base.loads[Component::wing_wake_right].force.z,
            1.26 / 1.07, 1e-12);
  // Fin area 20.25 of 25.25 ft2; tail pressure 0.8 at mast 0.
  const Evaluation<double> fin = with(helicopter, [](Options& o) { o.fin_area = FinArea::report; });
  CHECK_REL(fin.loads[Component::fin_left].force.y / base.loads[Component::fin_left].force.y, 20.25 / 25.25,
            1e-12);
  const Evaluation<double> tail =
      with(helicopter, [](Options& o) { o.tail_pressure = TailPressure::constant; });
  CHECK_REL(tail.loads[Component::htail].moment.y / base.loads[Component::htail].moment.y, 0.8, 1e-12);
  // Inertia as flown: 1.46 and 1.30 times the printed one.
  Options still_flying;
  const Configuration<double> simulated = configuration(0, still_flying);
  still_flying.inertia = InertiaSet::flown;
  const Configuration<double> heavier = configuration(0, still_flying);
  CHECK_REL(heavier.mass.inertia.yy / simulated.mass.inertia.yy, 1.46, 1e-12);
  CHECK_REL(heavier.mass.inertia.zz / simulated.mass.inertia.zz, 1.30, 1e-12);
  CHECK_EQ(heavier.mass.inertia.xx, simulated.mass.inertia.xx);
  // Rigging: 1.5 deg (1 - cos mast), disks forward.
  for (const double mast : {0.0, 60.0, 90.0}) {
    Options unrigged;
    unrigged.cyclic_rigging = false;
    const Controls<double> neutral{};
    const Vec3<double> at_rest{0, 0, 0};
    const double rigging = mix_controls(configuration(mast), neutral, at_rest).long_cyclic[right] -
                           mix_controls(configuration(mast, unrigged), neutral, at_rest).long_cyclic[right];
    CHECK_NEAR(rigging / kRadPerDeg<double>, 1.5 * (1 - std::cos(mast * kRadPerDeg<double>)), 1e-12);
  }
  // Angular acceleration of the hub: b1c'' + wy', b1s'' - wx' in each rotor's frame (mast 0, no cant: y = q',
  // x = -+p').
  const auto inertial = [](Options& o) { o.mast_cant = false; };
  const Evaluation<double> still = with(helicopter, inertial);
  const Evaluation<double> moving = with(helicopter, [&](Options& o) {
    inertial(o);
    o.flap_angular_acceleration = true;
  });
  for (const int side : {right, left}) {
    const double hand = side == right ? 1 : -1;
    const RotorState<double>& a = still.rates.rotor[side];
    const RotorState<double>& b = moving.rates.rotor[side];
    CHECK_NEAR(b.b1c_rate - a.b1c_rate, still.rates.rates.y, 1e-11);
    CHECK_NEAR(b.b1s_rate - a.b1s_rate, hand * still.rates.rates.x, 1e-11);
  }
  // Disk-plane inflow: the same as a climb of mx b1c + my b1s.
  const Configuration<double> shaft = configuration(0);
  Options tilted_options;
  tilted_options.disk_plane_inflow = true;
  const Configuration<double> tilted = configuration(0, tilted_options);
  RotorInput<double> in{};
  in.velocity_a = {-30, 4, 2};
  in.state.b1c = 0.05;
  in.state.b1s = -0.03;
  const RotorLoads<double> loads{{{0, 0, 3e4}, 0}, 0, 0, 0};
  const double through = inflow_forcing(tilted, in, loads).mu_z - inflow_forcing(shaft, in, loads).mu_z;
  CHECK_NEAR(through, (30 * 0.05 + 4 * 0.03) / shaft.tip_speed, 1e-15);
  // Side-by-side factor: nothing below mu 0.05, -0.085 above 0.2.
  Options pair_options;
  pair_options.side_by_side = true;
  const Configuration<double> pair = configuration(0, pair_options);
  in.velocity_a = {-0.03 * pair.tip_speed, 0, 0};
  CHECK_REL(inflow_forcing(pair, in, loads).c0 / inflow_forcing(shaft, in, loads).c0, 1.0, 1e-9);
  in.velocity_a = {-0.25 * pair.tip_speed, 0, 0};
  CHECK_NEAR(inflow_forcing(pair, in, loads).c0 / inflow_forcing(shaft, in, loads).c0, 1 - 0.085, 2e-3);
}

// At mast 90 the cant has gone.
TEST(options_mast_cant_ends_in_airplane_mode) {
  Options options;
  options.mast_cant = false;
  const auto a = flat(evaluated({90}, Options{}).rates);
  const auto b = flat(evaluated({90}, options).rates);
  for (std::size_t i = 0; i < a.size(); ++i) CHECK_NEAR(a[i], b[i], 1e-11 * (1 + std::abs(a[i])));
}

// Coning as a state at the constant's value and rest: the same loads.
TEST(options_coning_state_at_the_constant) {
  Options options;
  options.coning_states = true;
  StateAndControls<double> s = state({}, Options{});
  const Configuration<double> constant = configuration(30);
  for (const int side : {right, left}) s.x.coning[side] = {constant.coning, 0};
  Evaluation<double> a;
  Evaluation<double> b;
  evaluate_aircraft(constant, s.x, s.u, a);
  evaluate_aircraft(configuration(30, options), s.x, s.u, b);
  CHECK_EQ(changed(a, b), static_cast<unsigned>(coning_rates));
}

// The number of live states: 24 with heading, 23 without; switches take away or add theirs.
TEST(options_active_states) {
  const auto count = [](auto&& set, bool heading = true) {
    Options o;
    set(o);
    return active_states(o, heading).count;
  };
  CHECK_EQ(count([](Options&) {}), 24);
  CHECK_EQ(count([](Options&) {}, false), 23);
  CHECK_EQ(count([](Options& o) { o.downwash_lag = false; }), 23);
  CHECK_EQ(count([](Options& o) { o.flapping = FlapOrder::first; }), 20);
  CHECK_EQ(count([](Options& o) { o.inflow = InflowShape::uniform; }), 20);
  CHECK_EQ(count([](Options& o) { o.coning_states = true; }), 28);
  CHECK_EQ(count([](Options& o) { o.position_states = true; }), 27);
  // A state that is not alive has no rate.
  for (int k = 0; k < 4; ++k) {
    Options o;
    if (k == 0) o.downwash_lag = false;
    if (k == 1) o.flapping = FlapOrder::first;
    if (k == 1) o.flap_angular_acceleration = true;  // belongs to the second-order equations alone
    if (k == 2) o.inflow = InflowShape::uniform;
    if (k == 3) o.coning_states = true;
    const auto rates = flat(evaluated({}, o).rates);
    const ActiveStates active = active_states(o, true);
    std::array<bool, state_count> live{};
    for (int i = 0; i < active.count; ++i) live[static_cast<std::size_t>(active.index[i])] = true;
    for (std::size_t i = 0; i < kStateIndex.position.x; ++i) {
      if (!live[i]) CHECK_EQ(rates[i], 0.0);
    }
  }
}

// Settings outside their ranges are refused, at both ends.
TEST(options_and_setup_ranges) {
  const LimitTables<double>& limits = aircraft().limits;
  const auto refused = [](auto&& set) {
    FlightSetup<double> setup = flight_setup(aircraft(), 30.0);
    set(setup);
    Configuration<double> c;
    return prepare(aircraft(), setup, c) == Status::out_of_range;
  };
  using S = FlightSetup<double>;
  CHECK(!refused([](S&) {}));
  CHECK(refused([](S& s) { s.mast_deg = -0.1; }));
  CHECK(refused([](S& s) { s.mast_deg = 90.1; }));
  CHECK(refused([](S& s) { s.mast_deg = std::nan(""); }));
  CHECK(refused([&](S& s) { s.mast_rate = limits.mast_rate.low - 0.1; }));
  CHECK(refused([&](S& s) { s.sl_cg = limits.sl_cg.high + 0.1; }));
  CHECK(refused([&](S& s) { s.wl_cg = limits.wl_cg.low - 0.1; }));
  CHECK(refused([&](S& s) { s.flap_deg = limits.flap_deg.high + 1; }));
  CHECK(refused([](S& s) { s.altitude = 12000; }));
  CHECK(refused([](S& s) { s.rotor_speed = 0; }));
  CHECK(refused([](S& s) { s.mass = -1; }));
  CHECK(refused([](S& s) { s.mass = std::nan(""); }));
  CHECK(refused([](S& s) { s.options.grid_refinement = 5; }));
  CHECK(refused([](S& s) { s.options.grid_refinement = 0; }));
  CHECK(refused([](S& s) { s.options.azimuth_stations = 2; }));
  CHECK(refused([](S& s) { s.options.azimuth_stations = 73; }));
  CHECK(refused([](S& s) { s.options.hub_spring_factor = std::nan(""); }));
  CHECK(refused([](S& s) { s.options.induced_power_factor = -0.1; }));
}

// The sets name what they are about, and leave everything else alone.
TEST(options_sets_are_what_they_say) {
  Options o;
  o.grid = BladeGrid::realtime;
  choose(DataSet::as_flown, o);
  CHECK(o.inertia == InertiaSet::flown);
  CHECK(o.tail_pressure == TailPressure::by_mast);
  CHECK(o.grid == BladeGrid::realtime);
  choose(DataSet::as_simulated, o);
  CHECK(o.inertia == Options{}.inertia);
  CHECK(o.tail_pressure == Options{}.tail_pressure);
  const Options reference = reference_options();
  CHECK(reference.radial_inflow == RadialInflow::constant && reference.nacelle_mass == NacelleMass::quoted);
  CHECK(!reference.cyclic_rigging);
}
