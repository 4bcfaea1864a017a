#include "cli/qlpv_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/transfer_of.hpp"

namespace tiltrotor::cli {

namespace {

constexpr int kBandSteps = 80;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
double frequency(int step) {
  return kQlpvBand[0] * std::pow(kQlpvBand[1] / kQlpvBand[0], static_cast<double>(step) / kBandSteps);
}

double largest_response(TransferOf& of) {
  double largest = 0;
  for (int k = 0; k <= kBandSteps; ++k) largest = std::max(largest, std::abs(of.at({0, frequency(k)})));
  return largest;
}

QlpvResponse response_error(TransferOf& exact, TransferOf& interpolated) {
  QlpvResponse worst{"", 0, kQlpvBand[0]};
  for (int k = 0; k <= kBandSteps; ++k) {
    const double omega = frequency(k);
    const std::complex<double> g = exact.at({0, omega});
    const std::complex<double> h = interpolated.at({0, omega});
    const double error = std::abs(h - g) / std::abs(g);
    if (!(error <= worst.error)) worst = {"", error, omega};
  }
  return worst;
}

bool is_among(const int* list, int count, int wanted) {
  return std::find(list, list + count, wanted) != list + count;
}

struct Roots {
  VehicleModes<double> modes;
  Eigensystem<double, kMaxVehicleStates> system;
  int states;

  Status find(const VehicleMatrices& model, Analyses& work) {
    const Status status = vehicle_modes(model, work, modes);
    system = vehicle_eigensystem(work);
    states = model.shape.states;
    return status;
  }
  // |left^H right| of a mode here and one there.
  double product(int mode, const Roots& other, int of_other) const {
    std::complex<double> sum = 0;
    for (int k = 0; k < states; ++k) {
      const auto w = left_entry(system, k, modes.mode[mode].eigenvalue);
      const auto v = right_entry(other.system, k, other.modes.mode[of_other].eigenvalue);
      sum += std::complex<double>(w.real, -w.imag) * std::complex<double>(v.real, v.imag);
    }
    return std::abs(sum);
  }
  // overlap() of modes; none of a pair with a real root.
  double likeness(int mode, const Roots& other, int of_other) const {
    if ((modes.mode[mode].imag > 0) != (other.modes.mode[of_other].imag > 0)) return 0;
    const double own = product(mode, *this, mode) * other.product(of_other, other, of_other);
    return own > 0 ? product(mode, other, of_other) * other.product(of_other, *this, mode) / own : 0;
  }
};

// Which of `other` continues each mode, -1 for none: more than half like it, the surest first, as follow().
std::vector<int> continued_by(const Roots& found, const Roots& other) {
  std::vector<int> by(static_cast<std::size_t>(found.modes.count), -1);
  std::vector<bool> used(static_cast<std::size_t>(other.modes.count), false);
  for (int round = 0; round < found.modes.count; ++round) {
    double best = 0.5;
    std::size_t from = 0, to = used.size();
    for (std::size_t i = 0; i < by.size(); ++i)
      for (std::size_t k = 0; k < used.size(); ++k) {
        if (by[i] >= 0 || used[k]) continue;
        const double likeness = found.likeness(static_cast<int>(i), other, static_cast<int>(k));
        if (likeness <= best) continue;
        best = likeness;
        from = i;
        to = k;
      }
    if (to == used.size()) break;
    by[from] = static_cast<int>(to);
    used[to] = true;
  }
  return by;
}

}  // namespace

double QlpvRoot::error() const { return std::abs(interpolated - exact) / std::abs(exact); }
double QlpvReading::error() const {
  constexpr double rounding = 1e-9;  // of a search for a trim
  return std::abs(exact) > rounding * reach ? std::abs(interpolated - exact) / std::abs(exact) : kNothing;
}

std::unique_ptr<VehicleMatrices> mean_model(const std::vector<const VehicleMatrices*>& corners) {
  auto mean = std::make_unique<VehicleMatrices>(*corners.front());
  const double share = 1 / static_cast<double>(corners.size());
  const auto average = [&](auto&& entry_of) {
    double sum = 0;
    for (const VehicleMatrices* corner : corners) sum += entry_of(*corner);
    return share * sum;
  };
  for (int i = 0; i < mean->shape.states; ++i) {
    for (int j = 0; j < mean->shape.states; ++j)
      mean->a(i, j) = average([&](const VehicleMatrices& m) { return m.a(i, j); });
    for (int j = 0; j < mean->shape.inputs; ++j)
      mean->b(i, j) = average([&](const VehicleMatrices& m) { return m.b(i, j); });
  }
  return mean;
}

Status qlpv_errors(const VehicleMatrices& exact, const VehicleMatrices& interpolated, Analyses& work,
                   QlpvErrors& out) {
  out = {};
  const auto found = std::make_unique<Roots>();
  const auto other = std::make_unique<Roots>();
  Status status = found->find(exact, work);
  if (status == Status::ok) status = other->find(interpolated, work);
  if (status != Status::ok) return status;
  const std::vector<int> by = continued_by(*found, *other);
  for (int i = 0; i < found->modes.count; ++i) {
    const VehicleMode<double>& m = found->modes.mode[i];
    QlpvRoot root{m.is_system ? "system" : axis_word(m.axis), m.name, {m.real, m.imag}, {kNothing, kNothing}};
    const int k = by[static_cast<std::size_t>(i)];
    if (k >= 0) root.interpolated = {other->modes.mode[k].real, other->modes.mode[k].imag};
    out.roots.push_back(root);
  }

  const VehicleShape& shape = exact.shape;
  const int throttle = control_count + kCommandIndex.throttle[right];
  const bool is_ideal = is_among(shape.input, shape.inputs, throttle) &&
                        !is_among(shape.state, shape.states, state_count + kSystemIndex.rotor_speed);
  const ChannelChoice pairs[] = {{kStateIndex.velocity.z, is_ideal ? throttle : kControlIndex.collective},
                                 {kStateIndex.rates.y, kControlIndex.long_stick},
                                 {kStateIndex.rates.x, kControlIndex.lat_stick},
                                 {kStateIndex.rates.z, kControlIndex.pedal},
                                 {state_count + kSystemIndex.rotor_speed, throttle}};
  TransferOf g, h;
  for (const ChannelChoice& pair : pairs) {
    if (!is_among(shape.state, shape.states, pair.output)) continue;
    if (!is_among(shape.input, shape.inputs, pair.input)) continue;
    status = g.find(exact, pair);
    if (status == Status::ok) status = h.find(interpolated, pair);
    if (status != Status::ok) return status;
    QlpvResponse worst = response_error(g, h);
    worst.name = std::string(vehicle_input(pair.input).name) + ">" + vehicle_variable(pair.output).name;
    out.responses.push_back(worst);
  }
  return Status::ok;
}

Status qlpv_output_errors(const QlpvPoint& exact, const VehicleMatrices& mean,
                          const std::vector<const ShownModel*>& corners, QlpvErrors& out) {
  const VehicleShape& shape = exact.model->shape;
  const auto mean_of = [&corners](auto&& entry_of) {
    double sum = 0;
    for (const ShownModel* corner : corners) sum += entry_of(*corner);
    return sum / static_cast<double>(corners.size());
  };
  TransferOf g, h;
  for (int i = 0; i < exact.shown.outputs; ++i) {
    const std::string name = exact.shown.output_name(i);
    const auto y = static_cast<std::size_t>(i);
    QlpvReading reading{name, exact.shown.y[y],
                        mean_of([y](const ShownModel& corner) { return corner.y[y]; }), 0};
    int by = -1;
    const auto find_exact = [&](int input) {
      return g.find(
          *exact.model, shape.input[input], [&](int j) { return exact.shown.c(i, j); },
          [&](int k) { return exact.shown.d(i, k); });
    };
    for (int k = 0; k < shape.inputs; ++k) {
      const Status status = find_exact(k);
      if (status != Status::ok) return status;
      const double size = largest_response(g) * vehicle_input(shape.input[k]).facts().bend;
      if (size <= reading.reach) continue;
      reading.reach = size;
      by = k;
    }
    out.readings.push_back(reading);
    if (by < 0) {
      out.responses.push_back({"none>" + name, kNothing, kNothing});
      continue;
    }
    Status status = find_exact(by);
    if (status == Status::ok)
      status = h.find(
          mean, shape.input[by],
          [&](int j) { return mean_of([&](const ShownModel& corner) { return corner.c(i, j); }); },
          [&](int k) { return mean_of([&](const ShownModel& corner) { return corner.d(i, k); }); });
    if (status != Status::ok) return status;
    QlpvResponse worst = response_error(g, h);
    worst.name = std::string(vehicle_input(shape.input[by]).name) + ">" + name;
    out.responses.push_back(worst);
  }
  return Status::ok;
}

}  // namespace tiltrotor::cli
