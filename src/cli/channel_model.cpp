#include "cli/channel_model.hpp"

#include <algorithm>
#include <cmath>

namespace tiltrotor::cli {

namespace {

// psi' = (q sin phi + r cos phi) / cos theta, to first order about the trim.
struct HeadingRate {
  double by_q, by_r, by_phi, by_theta;
  explicit HeadingRate(const State<double>& x) {
    const double sine = std::sin(x.roll), cosine = std::cos(x.roll), level = std::cos(x.pitch);
    by_q = sine / level;
    by_r = cosine / level;
    by_phi = (x.rates.y * cosine - x.rates.z * sine) / level;
    by_theta = (x.rates.y * sine + x.rates.z * cosine) / level * std::tan(x.pitch);
  }
  double by(int state) const {
    return state == kStateIndex.rates.y   ? by_q
           : state == kStateIndex.rates.z ? by_r
           : state == kStateIndex.roll    ? by_phi
           : state == kStateIndex.pitch   ? by_theta
                                          : 0;
  }
};

int place(const std::vector<NamedOutput>& outputs, const std::string& name) {
  const auto is = [&](const NamedOutput& output) { return output.name == name; };
  return static_cast<int>(std::find_if(outputs.begin(), outputs.end(), is) - outputs.begin());
}

}  // namespace

ChannelModel::ChannelModel(const Arguments& arguments, const Options& options)
    : scas_(wants_scas(arguments)),
      feedback_(arguments, options, scas_),
      choices_(channel_choices(arguments, governed_shape(options, kAllControls, scas_))) {
  for (const ChannelChoice& which : choices_) {
    if (!which.named) continue;
    const bool read = which.named->reading >= 0;
    reads_instruments_ = reads_instruments_ || read;
    const auto known = static_cast<std::size_t>(place(airframe_, which.named->name));
    if (!read && known == airframe_.size()) airframe_.push_back(*which.named);
  }
}

Status ChannelModel::find(const TrimmedFlight& flight, Analyses& work) {
  const Configuration<double>& c = flight.configuration;
  x_ = flight.trim.state;
  const Status status =
      feedback_.linearize_governed(c, x_, flight.trim.controls, kAllControls, work, *matrices_, scas_,
                                   reads_instruments_ ? instruments_.get() : nullptr);
  if (status != Status::ok || airframe_.empty()) return status;
  Controls<double> u = flight.trim.controls;
  const SystemFlight<double> systems = governed(c, x_, u, scas_);
  return feedback_.linearize_rows(systems, c, x_, u, kAllControls, scas_, airframe_, rows_);
}

Status ChannelModel::find_channel(const ChannelChoice& which, TransferOf& transfer) const {
  const VehicleMatrices& m = *matrices_;
  if (which.is_heading()) {
    const HeadingRate rate(x_);
    const Status status = transfer.find(
        m, which.input, [&](int j) { return rate.by(m.shape.state[j]); }, [](int) { return 0.0; });
    return status == Status::ok ? transfer.integrate() : status;
  }
  if (!which.named) return transfer.find(m, which);
  const auto by_rows_of = [&](const auto& outputs, int row) {
    return transfer.find(
        m, which.input, [&](int j) { return outputs.c(row, j); }, [&](int k) { return outputs.d(row, k); });
  };
  const int reading = which.named->reading;
  return reading >= 0 ? by_rows_of(*instruments_, reading)
                      : by_rows_of(rows_, place(airframe_, which.named->name));
}

}  // namespace tiltrotor::cli
