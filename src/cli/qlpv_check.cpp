#include "cli/qlpv_check.hpp"

#include <cmath>
#include <limits>

#include "tiltrotor/analysis/linear/channel.hpp"

namespace tiltrotor::cli {

namespace {

struct Channels {
  VehicleChannel<double> channel;
  TransferFunctionWorkspace<double, kMaxVehicleStates> roots;
  ResponseWorkspace<double, kMaxVehicleStates> response;
};

// Rows and columns of a model; -1: not there.
int place_of(const int* list, int count, int wanted) {
  for (int i = 0; i < count; ++i)
    if (list[i] == wanted) return i;
  return -1;
}

Status transfer_of(const LinearModel<double>& model, int row, int column, Channels& work,
                   VehicleTransfer<double>& out) {
  set_channel(model, row, column, work.channel);
  return transfer_function(work.channel, work.roots, out);
}

QlpvResponse response_error(const VehicleTransfer<double>& exact, const VehicleTransfer<double>& interpolated,
                            Channels& work) {
  constexpr int steps = 80;
  QlpvResponse worst{"", 0, kQlpvBand[0]};
  for (int k = 0; k <= steps; ++k) {
    const double omega = kQlpvBand[0] * std::pow(kQlpvBand[1] / kQlpvBand[0], static_cast<double>(k) / steps);
    const std::complex<double> g = response(exact, {0, omega}, work.response);
    const std::complex<double> h = response(interpolated, {0, omega}, work.response);
    const double error = std::abs(h - g) / std::abs(g);
    if (!(error <= worst.error)) worst = {"", error, omega};
  }
  return worst;
}

}  // namespace

double QlpvRoot::error() const { return std::abs(interpolated - exact) / std::abs(exact); }

LinearModel<double> mean_model(const std::vector<const LinearModel<double>*>& corners) {
  LinearModel<double> mean = *corners.front();
  const double share = 1 / static_cast<double>(corners.size());
  const auto average = [&](auto&& entry_of) {
    double sum = 0;
    for (const LinearModel<double>* corner : corners) sum += entry_of(*corner);
    return share * sum;
  };
  for (int i = 0; i < mean.states; ++i) {
    for (int j = 0; j < mean.states; ++j)
      mean.a(i, j) = average([&](const LinearModel<double>& m) { return m.a(i, j); });
    for (int j = 0; j < mean.controls; ++j)
      mean.b(i, j) = average([&](const LinearModel<double>& m) { return m.b(i, j); });
    mean.x[i] = average([i](const LinearModel<double>& m) { return m.x[i]; });
  }
  for (int j = 0; j < mean.controls; ++j)
    mean.u[j] = average([j](const LinearModel<double>& m) { return m.u[j]; });
  return mean;
}

Status qlpv_errors(const LinearModel<double>& exact, const LinearModel<double>& interpolated,
                   QlpvErrors& out) {
  out = {};
  const auto work = std::make_unique<ModesWorkspace<double>>();
  const auto found = std::make_unique<ModeSet<double>>();
  const auto other = std::make_unique<ModeSet<double>>();
  Status status = modes(exact, *work, *found);
  if (status == Status::ok) status = modes(interpolated, *work, *other);
  if (status == Status::ok) status = follow(*found, *other);
  if (status != Status::ok) return status;
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < found->count; ++i) {
    const Mode<double>& m = found->mode[i];
    QlpvRoot root{axis_word(m.axis), m.name, {m.real, m.imag}, {nothing, nothing}};
    for (int k = 0; k < other->count; ++k)
      if (other->mode[k].branch == m.branch) root.interpolated = {other->mode[k].real, other->mode[k].imag};
    out.roots.push_back(root);
  }

  const auto channels = std::make_unique<Channels>();
  const auto g = std::make_unique<VehicleTransfer<double>>();
  const auto h = std::make_unique<VehicleTransfer<double>>();
  const int pairs[][2] = {{kControlIndex.collective, kStateIndex.velocity.z},
                          {kControlIndex.long_stick, kStateIndex.rates.y},
                          {kControlIndex.lat_stick, kStateIndex.rates.x},
                          {kControlIndex.pedal, kStateIndex.rates.z}};
  for (const auto& [control, state] : pairs) {
    const int row = place_of(exact.state, exact.states, state);
    const int column = place_of(exact.control, exact.controls, control);
    if (row < 0 || column < 0) continue;
    status = transfer_of(exact, row, column, *channels, *g);
    if (status == Status::ok) status = transfer_of(interpolated, row, column, *channels, *h);
    if (status != Status::ok) return status;
    QlpvResponse worst = response_error(*g, *h, *channels);
    worst.name = std::string(exact.control_name(column)) + ">" + exact.state_name(row);
    out.responses.push_back(worst);
  }
  return Status::ok;
}

}  // namespace tiltrotor::cli
