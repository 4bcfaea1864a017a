// A and B of the whole vehicle: against a complex step through the same text, which shares nothing with dual numbers
// nor with the expansion of the airframe; against central differences of the rates; against the airframe's own where
// nothing is switched on.
#include <complex>

#include "somewhere.hpp"
#include "tiltrotor/math/differentiation/complex_step.hpp"

using namespace vehicle_case;
using Complex = std::complex<double>;

namespace vehicle_case {

const Matrices& matrices(const Vehicle<double>& v, const Configuration<double>& c, const State<double>& x,
                         const SystemState<double>& s, const Controls<double>& u, double azimuth,
                         Inputs inputs) {
  static VehicleModelWorkspace<double> work;
  static Matrices m;
  m = Matrices{};
  Configuration<double> at = c;
  vehicle_states(v, c.setup.options, m.shape);
  for (int j = 0; j < vehicle_input_count; ++j)
    if (inputs == Inputs::all || (j < control_count && kControlVariables[j].kind == VariableKind::stick))
      m.shape.input[m.shape.inputs++] = j;
  m.status = linearize_vehicle(
      v, at, x, s, u, m.shape, work, m.xdot, m.sdot,
      [](int i, int j, int count, const double* slope) { std::copy(slope, slope + count, m.a[i] + j); },
      [](int i, int j, int count, const double* slope) { std::copy(slope, slope + count, m.b[i] + j); },
      azimuth);
  return m;
}

Change complex_step(const Somewhere& at, const double* dx, const double* du) {
  static Configuration<Complex> c;
  static DerivativeSteps<Complex> steps;
  double flat[vehicle_state_count], inputs[vehicle_input_count];
  Complex states[vehicle_state_count], moved[vehicle_input_count];
  flatten(at.x, flat);
  flatten(at.s, flat + state_count);
  flatten(at.u, inputs);
  flatten(at.v.commands, inputs + control_count);
  const double step = 1e-30;
  for (int i = 0; i < vehicle_state_count; ++i) states[i] = Complex(flat[i], step * dx[i]);
  for (int j = 0; j < vehicle_input_count; ++j) moved[j] = Complex(inputs[j], step * du[j]);

  State<Complex> x;
  SystemState<Complex> systems, of_systems;
  Controls<Complex> u;
  Commands<Complex> commands;
  unflatten(states, x);
  unflatten(states + state_count, systems);
  unflatten(moved, u);
  unflatten(moved + control_count, commands);
  moved_configuration<Complex>(at.c, nullptr, nullptr, 0, c);
  AirframeDemand<Complex> demand;
  AirframeAnswer<Complex> answer;
  VehicleFlows<Complex> flows;
  vehicle_rates<Complex>(at.v, at.c, at.c.setup, c, x, systems, commands, u,
                         VehicleAirframe<Complex>{c, x, steps, at.azimuth}, demand, answer, flows,
                         of_systems);
  // What a mast carries speeds its rotor up, too.
  put_spin_up(at.v, of_systems, c);
  Instruments<Complex> read;
  read_instruments(c, x, steps, answer.rates, read);
  Complex found[vehicle_state_count], readings[Instruments<double>::kCount];
  flatten(answer.rates, found);
  flatten(of_systems, found + state_count);
  flatten(read, readings);
  Change change;
  for (int i = 0; i < vehicle_state_count; ++i) change.of[i] = found[i].imag() / step;
  for (int i = 0; i < Instruments<double>::kCount; ++i) change.readings[i] = readings[i].imag() / step;
  return change;
}

}  // namespace vehicle_case

namespace {

// The column of a variable.
void complex_column(const Somewhere& at, const VehicleShape& shape, int j, double* column) {
  double dx[vehicle_state_count] = {}, du[vehicle_input_count] = {};
  (j < shape.states ? dx[shape.state[j]] : du[shape.input[j - shape.states]]) = 1;
  const Change change = complex_step(at, dx, du);
  for (int i = 0; i < shape.states; ++i) column[i] = change.of[shape.state[i]];
}

// Largest error of a column of A and B over the largest entry of that column.
struct Worst {
  double error = 0;
  const char* row = "";
  const char* column = "";
};
template <class Column>
void compare(const Matrices& m, bool governed, Column&& column_of, Worst& worst) {
  for (int j = 0; j < m.shape.states + m.shape.inputs; ++j) {
    double column[kMaxVehicleStates];
    column_of(j, column);
    // An ideal governor takes back what the lever gives: rounding of open-loop entries of some thousands is left.
    const bool taken_back =
        governed && j >= m.shape.states && m.shape.input[j - m.shape.states] == kControlIndex.collective;
    double size = taken_back ? 1000 : 0.01;
    for (int i = 0; i < m.shape.states; ++i) size = std::max(size, std::fabs(column[i]));
    for (int i = 0; i < m.shape.states; ++i) {
      const double found = j < m.shape.states ? m.a[i][j] : m.b[i][j - m.shape.states];
      const double error = std::fabs(found - column[i]) / size;
      if (error <= worst.error) continue;
      worst.error = error;
      worst.row = vehicle_variable(m.shape.state[i]).name;
      worst.column = j < m.shape.states ? vehicle_variable(m.shape.state[j]).name
                                        : vehicle_input(m.shape.input[j - m.shape.states]).name;
    }
  }
}

void compare_with_complex_step(unsigned seed, int count, const Options& options = realtime(),
                               double rotor_acceleration = 0) {
  Dice dice(seed);
  Worst worst[3];
  int compared = 0;
  for (int k = 0; k < count; ++k) {
    const Governor governor = static_cast<Governor>(k % 3);
    Somewhere at = somewhere(dice, governor, options);
    const bool averaged = options.azimuth == AzimuthMode::averaged;
    if (!averaged) at.azimuth = 0.7;
    if (governor != Governor::pi) {
      at.c.setup.rotor_acceleration = rotor_acceleration;
      configure(at.c);
    }
    if (governor == Governor::ideal && (!averaged || !is_governed(at))) continue;
    // For the sticks alone the airframe is moved along fewer controls.
    const Inputs inputs = k % 5 == 4 ? Inputs::sticks : Inputs::all;
    const Matrices& m = matrices(at.v, at.c, at.x, at.s, at.u, at.azimuth, inputs);
    if (!CHECK(m.status == Status::ok)) return;
    ++compared;
    compare(
        m, governor == Governor::ideal,
        [&](int j, double* column) { complex_column(at, m.shape, j, column); }, worst[k % 3]);
  }
  for (const Worst& w : worst)
    NOTE("worst of " << compared << " points, governor off, ideal, pi: " << w.error << " of the column, row "
                     << w.row << " column " << w.column);
  for (const Worst& w : worst) CHECK_LT(w.error, 1e-11);
  CHECK_LT(0.6 * count, compared);
}

}  // namespace

TEST(vehicle_linear_model_equals_complex_step) { compare_with_complex_step(1, 60); }
// Rotors of other laws, whose expansion the configuration goes through as well.
TEST(vehicle_linear_model_of_other_rotors_equals_complex_step) {
  Options first_order = realtime(), individual = realtime(), uniform = realtime();
  first_order.flapping = FlapOrder::first;
  individual.azimuth = AzimuthMode::individual;
  uniform.inflow = InflowShape::uniform;
  unsigned seed = 11;
  for (const Options& options : {first_order, individual, uniform})
    compare_with_complex_step(seed++, 12, options);
  compare_with_complex_step(seed, 12, realtime(), 1.5);
}
// What is no number is said.
TEST(vehicle_linear_model_says_what_is_not_finite) {
  Dice dice(5);
  for (const Governor governor : {Governor::off, Governor::pi}) {
    Somewhere at = somewhere(dice, governor);
    at.x.rates.y = std::nan("");
    CHECK(matrices(at.v, at.c, at.x, at.s, at.u).status == Status::not_finite);
  }
}
TEST(slow_vehicle_linear_model_equals_complex_step) { compare_with_complex_step(2, 1000); }

TEST(vehicle_linear_model_equals_central_differences) {
  Dice dice(3);
  Worst worst;
  for (int k = 0; k < 9; ++k) {
    const Governor governor = static_cast<Governor>(k % 3);
    const Somewhere at = somewhere(dice, governor);
    if (governor == Governor::ideal && !is_governed(at)) continue;
    const Matrices& m = matrices(at.v, at.c, at.x, at.s, at.u);
    double flat[vehicle_state_count], inputs[vehicle_input_count];
    flatten(at.x, flat);
    flatten(at.s, flat + state_count);
    flatten(at.u, inputs);
    flatten(at.v.commands, inputs + control_count);
    const auto difference = [&](int j, double* column) {
      const bool is_state = j < m.shape.states;
      double& moved = is_state ? flat[m.shape.state[j]] : inputs[m.shape.input[j - m.shape.states]];
      const KindFacts& facts = is_state ? vehicle_variable(m.shape.state[j]).facts()
                                        : vehicle_input(m.shape.input[j - m.shape.states]).facts();
      const double middle = moved, step = 2e-6 * facts.bend;
      Rates side[2];
      for (const int sign : {0, 1}) {
        moved = middle + (sign == 0 ? -step : step);
        Somewhere near = at;
        unflatten(flat, near.x);
        unflatten(flat + state_count, near.s);
        unflatten(inputs, near.u);
        unflatten(inputs + control_count, near.v.commands);
        side[sign] = rates(near.v, near.c, near.x, near.s, near.u);
      }
      moved = middle;
      for (int i = 0; i < m.shape.states; ++i) {
        const int place = m.shape.state[i];
        column[i] = (side[1].of[place] - side[0].of[place]) / (2 * step);
      }
    };
    compare(m, governor == Governor::ideal, difference, worst);
  }
  NOTE("worst " << worst.error << " of the column, row " << worst.row << " column " << worst.column);
  CHECK_LT(worst.error, 2e-4);
}

// Rates of the model are those of vehicle_rates(), to the bit.
TEST(vehicle_linear_model_tells_the_rates) {
  Dice dice(4);
  for (const Governor governor : {Governor::off, Governor::ideal, Governor::pi}) {
    const Somewhere at = somewhere(dice, governor);
    const Rates r = rates(at.v, at.c, at.x, at.s, at.u);
    const Matrices& m = matrices(at.v, at.c, at.x, at.s, at.u);
    double found[vehicle_state_count];
    flatten(m.xdot, found);
    flatten(m.sdot, found + state_count);
    for (int i = 0; i < vehicle_state_count; ++i) CHECK_EQ(found[i], r.of[i]);
  }
}

// Nothing on: A and B are the airframe's.
TEST(vehicle_without_systems_has_the_airframes_linear_model) {
  Dice dice(5);
  for (int k = 0; k < 4; ++k) {
    Somewhere at = somewhere(dice, Governor::off);
    at.v.on = kNone;
    at.v.air_follows = false;
    const Matrices& m = matrices(at.v, at.c, at.x, at.s, at.u);
    static LinearModel<double> model;
    linear_model(at.c, at.x, at.u, kAllControls, model);
    CHECK(m.status == Status::ok);
    CHECK_EQ(m.shape.states, model.states);
    double worst = 0;
    for (int i = 0; i < model.states; ++i) {
      CHECK_EQ(m.shape.state[i], model.state[i]);
      for (int j = 0; j < model.states; ++j) {
        const double size = std::max(1.0, std::fabs(model.a(i, j)));
        worst = std::max(worst, std::fabs(m.a[i][j] - model.a(i, j)) / size);
      }
      for (int j = 0; j < control_count; ++j) {
        const double size = std::max(1.0, std::fabs(model.b(i, j)));
        worst = std::max(worst, std::fabs(m.b[i][j] - model.b(i, j)) / size);
      }
      for (int j = control_count; j < vehicle_input_count; ++j) CHECK_EQ(m.b[i][j], 0.0);
    }
    NOTE("worst " << worst);
    CHECK_LE(worst, 1e-13);
  }
}

// A load of the systems acts as one of the surroundings does, flapping included where it feels the hub's acceleration.
TEST(vehicle_expansion_takes_a_load_as_the_airframe_does) {
  struct Felt {
    bool by_blades;
    FlapOrder order;
  };
  for (const Felt felt :
       {Felt{false, FlapOrder::second}, Felt{true, FlapOrder::second}, Felt{true, FlapOrder::first}}) {
    Options options = realtime();
    options.flap_angular_acceleration = felt.by_blades;
    options.flapping = felt.order;
    const Configuration<double> c = flown_configuration(30, 0, options);
    const Point p = slanted_point();
    const double weight = c.setup.mass * kGravity<double>;
    const Loads<double> load = {{0.3 * weight, -0.2 * weight, 0.1 * weight},
                                {0.2 * weight, -0.3 * weight, 0.4 * weight}};
    Configuration<double> loaded = c;
    loaded.outside = loaded.outside + load;
    State<double> without, with_load, added{};
    derivative(c, p.x, p.u, without);
    derivative(loaded, p.x, p.u, with_load);
    add_load(c, load, added);
    double a[state_count], b[state_count], d[state_count];
    flatten(without, a);
    flatten(with_load, b);
    flatten(added, d);
    for (int i = 0; i < state_count; ++i) CHECK_NEAR(d[i], b[i] - a[i], 1e-10 * (1 + std::fabs(a[i])));
  }
}
