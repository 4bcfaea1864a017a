// The transfer function of a channel of a linear model, on the heap.
#pragma once

#include <memory>

#include "cli/channel_options.hpp"
#include "library/analyses.hpp"
#include "tiltrotor/analysis/linear/frequency_measures.hpp"

namespace tiltrotor::cli {

class TransferOf {
 public:
  // A state of the model. Status: those of transfer_function().
  Status find(const VehicleMatrices& m, const ChannelChoice& which) {
    int row = 0;
    while (m.shape.state[row] != which.output) ++row;
    return find(
        m, which.input, [row](int j) { return j == row ? 1.0 : 0.0; }, [](int) { return 0.0; });
  }
  // y = sum c(j) x_j + d(k) u_k, by the columns of the model.
  template <class RowOfC, class RowOfD>
  Status find(const VehicleMatrices& m, int input, RowOfC&& c, RowOfD&& d) {
    int column = 0;
    while (m.shape.input[column] != input) ++column;
    set_channel(
        m.shape, input, [&](int i, int j) { return m.a(i, j); }, [&](int i) { return m.b(i, column); }, c,
        static_cast<double>(d(column)), channel());
    return transfer_function(channel(), work_->roots, work_->transfer);
  }
  // The integral of the output in its place: an attitude from its rate.
  Status integrate() {
    VehicleChannel<double>& s = channel();
    const int n = s.states++;
    for (int j = 0; j <= n; ++j) s.a(n, j) = j < n ? s.c[j] : 0;
    for (int i = 0; i < n; ++i) s.a(i, n) = s.c[i] = 0;
    s.c[n] = 1;
    s.b[n] = s.d;
    s.d = 0;
    return transfer_function(s, work_->roots, work_->transfer);
  }
  VehicleChannel<double>& channel() { return work_->channel; }
  const VehicleTransfer<double>& transfer() const { return work_->transfer; }
  std::complex<double> at(std::complex<double> s) { return response(transfer(), s, work_->response); }
  double phase(double omega, std::complex<double> value) const {
    return continuous_phase(transfer(), omega, value);
  }
  Bandwidth<double> find_bandwidth() { return bandwidth(transfer(), work_->response); }
  Status find_margins(double gain, Margins<double>& out) {
    return margins(channel(), transfer(), gain, work_->roots, work_->response, out);
  }

 private:
  struct Work {
    VehicleChannel<double> channel;
    VehicleTransfer<double> transfer;
    TransferFunctionWorkspace<double, kMaxVehicleStates> roots;
    ResponseWorkspace<double, kMaxVehicleStates> response;
  };
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
};

}  // namespace tiltrotor::cli
