#include "cli/handling_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cli/transfer_of.hpp"
#include "tiltrotor/model/rigid_body.hpp"
#include "tiltrotor/model/variables/control_range.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double degree = kRadPerDeg<double>;

struct AxisOfControl {
  const char* name;
  int rate, attitude, inceptor;
};
constexpr AxisOfControl axes[] = {{"pitch", kStateIndex.rates.y, kStateIndex.pitch, kControlIndex.long_stick},
                                  {"roll", kStateIndex.rates.x, kStateIndex.roll, kControlIndex.lat_stick},
                                  {"yaw", kStateIndex.rates.z, kStateIndex.yaw, kControlIndex.pedal}};

// Body rates with rotors, wash and series actuators in their balance; slower systems stand.
class SettledRates {
 public:
  explicit SettledRates(const VehicleMatrices& m) : m_(m) {
    const VehicleShape& shape = m.shape;
    for (int i = 0; i < shape.states; ++i) {
      const int state = shape.state[i];
      const bool series =
          state >= state_count + kSystemIndex.series[0] && state <= state_count + kSystemIndex.series[2];
      if (series || (state < state_count && !is_rigid(state))) fast_[count_++] = i;
    }
    for (int i = 0; i < count_; ++i)
      for (int j = 0; j < count_; ++j) matrix_(i, j) = m.a(fast_[i], fast_[j]);
    status = count_ > 0 ? lu_factor(matrix_, count_, lu_) : Status::ok;
  }
  // Of the rate of `state` by a state or an input, through the fast ones.
  double by_state(int state, int by) {
    const int column = place(m_.shape.state, m_.shape.states, by);
    return settled(state, [&](int i) { return m_.a(i, column); });
  }
  double by_input(int state, int input) {
    const int column = place(m_.shape.input, m_.shape.inputs, input);
    return settled(state, [&](int i) { return m_.b(i, column); });
  }
  Status status;

 private:
  static int place(const int* list, int count, int what) {
    return static_cast<int>(std::find(list, list + count, what) - list);
  }
  template <class Column>
  double settled(int state, Column&& column) {
    const int row = place(m_.shape.state, m_.shape.states, state);
    double drive[kMaxVehicleStates];
    for (int k = 0; k < count_; ++k) drive[k] = column(fast_[k]);
    if (count_ > 0 && lu_solve(lu_, drive) != Status::ok) return std::nan("");
    double sum = column(row);
    for (int k = 0; k < count_; ++k) sum -= m_.a(row, fast_[k]) * drive[k];
    return sum;
  }

  const VehicleMatrices& m_;
  int fast_[kMaxVehicleStates];
  int count_ = 0;
  Matrix<double, kMaxVehicleStates, kMaxVehicleStates> matrix_;
  LU<double, kMaxVehicleStates> lu_;
};

// Output of a channel after a step of its input by one, at times k dt, by fourth-order Runge-Kutta steps.
std::vector<double> step_response(const VehicleChannel<double>& s, double dt, double end) {
  const auto n = static_cast<std::size_t>(s.states);
  std::vector<double> x(n), y, k(n), at(n), sum(n);
  const auto rates = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < n; ++i) {
      double rate = s.b[i];
      for (std::size_t j = 0; j < n; ++j) rate += s.a(static_cast<int>(i), static_cast<int>(j)) * from[j];
      to[i] = rate;
    }
  };
  const double part[] = {0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
  for (double t = 0; t < end + dt / 2; t += dt) {
    double out = s.d;
    for (std::size_t i = 0; i < n; ++i) out += s.c[i] * x[i];
    y.push_back(out);
    std::fill(sum.begin(), sum.end(), 0.0);
    at = x;
    for (int stage = 0; stage < 4; ++stage) {
      rates(at, k);
      for (std::size_t i = 0; i < n; ++i) {
        sum[i] += weight[stage] * k[i];
        if (stage < 3) at[i] = x[i] + part[stage] * dt * k[i];
      }
    }
    for (std::size_t i = 0; i < n; ++i) x[i] += dt / 6 * sum[i];
  }
  return y;
}

// The way to the nearer stop, in.
double travel_left(const Configuration<double>& c, const Controls<double>& u, int inceptor) {
  double at[control_count];
  flatten(u, at);
  const Bounds<double> range = control_range(*c.aircraft, inceptor);
  return std::max(0.0, std::min(range.high - at[inceptor], at[inceptor] - range.low));
}

void add_modes(const VehicleModes<double>& modes, HandlingQuantities& out) {
  double least = infinite, least_lateral = infinite;
  for (int i = 0; i < modes.count; ++i) {
    const VehicleMode<double>& m = modes.mode[i];
    if (m.is_system || m.axis == ModeAxis::rotor) continue;
    const std::string name = m.name;
    constexpr double slowest_yaw = 0.5;  // rad/s, ADS-33E
    if (m.imag > 0) least = std::min(least, m.damping_ratio);
    if (m.imag > 0 && m.axis == ModeAxis::lateral && m.frequency > slowest_yaw)
      least_lateral = std::min(least_lateral, m.damping_ratio);
    if (name == "dutch_roll") {
      out["dutch_zeta"] = m.damping_ratio;
      out["dutch_zeta_omega"] = -m.real;
      out["dutch_omega"] = m.frequency;
    }
    if (name == "roll") out["roll_time"] = m.real < 0 ? -1 / m.real : infinite;
    if (name == "spiral") out["spiral_double_time"] = m.real > 0 ? std::log(2.0) / m.real : infinite;
    if (name == "roll_spiral") out["roll_spiral_zeta_omega"] = -m.real;
    if (name == "phugoid") out["phugoid_zeta"] = m.damping_ratio;
    if (name == "heave") out["heave_time"] = m.real < 0 ? -1 / m.real : infinite;
    if (name == "short_period") {
      out["short_period_zeta"] = m.damping_ratio;
      out["short_period_omega"] = m.frequency;
    }
  }
  if (least < infinite) out["oscillation_zeta"] = least;
  if (least_lateral < infinite) out["lateral_oscillation_zeta"] = least_lateral;
}

}  // namespace

Status handling_quantities(const Configuration<double>& c, const State<double>& x, const Controls<double>& u,
                           const VehicleMatrices& matrices, Analyses& work, HandlingQuantities& out) {
  out.clear();
  const auto modes = std::make_unique<VehicleModes<double>>();
  const Status found = vehicle_modes(matrices, work, *modes);
  if (found != Status::ok) return found;
  add_modes(*modes, out);

  const auto rates = std::make_unique<SettledRates>(matrices);
  if (rates->status != Status::ok) return rates->status;
  const double airspeed = std::sqrt(dot(x.velocity - u.gust, x.velocity - u.gust));
  const double load_per_alpha =
      -rates->by_state(kStateIndex.velocity.z, kStateIndex.velocity.z) * airspeed / kGravity<double>;
  if (out.count("short_period_omega") > 0 && load_per_alpha > 0)
    out["cap"] = out["short_period_omega"] * out["short_period_omega"] / load_per_alpha;

  constexpr double dt = 0.002, end = 10;  // s
  TransferOf transfer;
  for (const AxisOfControl& axis : axes) {
    const std::string name = axis.name;
    const double sensitivity = std::abs(rates->by_input(axis.rate, axis.inceptor));
    const double way = travel_left(c, u, axis.inceptor);
    out["sensitivity_" + name] = sensitivity;
    out["damping_" + name] = -rates->by_state(axis.rate, axis.rate);
    out["control_power_" + name] = sensitivity * way;

    const bool yaw = axis.attitude == kStateIndex.yaw;
    Status status = transfer.find(matrices, {yaw ? axis.rate : axis.attitude, axis.inceptor});
    if (status == Status::ok && yaw) status = transfer.integrate();
    if (status != Status::ok) return status;
    const Bandwidth<double> b = transfer.find_bandwidth();
    if (std::isfinite(b.rate_command)) out["bandwidth_" + name] = b.rate_command;
    const std::vector<double> step = step_response(transfer.channel(), dt, end);
    const auto after = [&](double time) {
      return std::abs(step[static_cast<std::size_t>(std::lround(time / dt))]) / degree;
    };
    out["attitude_half_" + name] = after(0.5);
    out["attitude_one_" + name] = after(1);
    if (name != "roll") continue;
    for (const int bank : {30, 45}) {
      double time = infinite;
      for (std::size_t k = 1; k < step.size() && time == infinite; ++k) {
        const double before = way * std::abs(step[k - 1]), now = way * std::abs(step[k]);
        if (now >= bank * degree)
          time = dt * (static_cast<double>(k - 1) + (bank * degree - before) / (now - before));
      }
      out["bank_" + std::to_string(bank)] = time;
    }
  }
  return Status::ok;
}

}  // namespace tiltrotor::cli
