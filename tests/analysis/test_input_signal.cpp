// Test inputs by what they sum to: sampled at steps that divide the duration, a pulse has exactly amplitude
// times duration and a doublet nothing, wherever they begin.
#include "tiltrotor/analysis/flight/input_signal.hpp"

#include "check.hpp"

using namespace tiltrotor;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kStep = 0.125;  // s; sums of it have no rounding

// Integral by rectangles from 0 to `end`.
double integral(const InputSignal<double>& s, double end) {
  double sum = 0;
  for (double t = 0; t < end; t += kStep) sum += kStep * value_at(s, t);
  return sum;
}

}  // namespace

TEST(input_signal_sums) {
  for (double start : {0.0, 0.5, 1.125}) {
    for (double duration : {0.25, 0.5, 2.0}) {
      const auto signal = [&](InputShape shape) {
        return InputSignal<double>{shape, kControlIndex.pedal, -3, start, duration};
      };
      CHECK_EQ(integral(signal(InputShape::pulse), 10), -3 * duration);
      CHECK_EQ(integral(signal(InputShape::doublet), 10), 0.0);
      // The first half of a doublet alone, then the second: as much and the other way.
      CHECK_EQ(integral(signal(InputShape::doublet), start + duration), -3 * duration);
      CHECK_EQ(integral(signal(InputShape::doublet), start + 1.5 * duration), -1.5 * duration);
      CHECK_EQ(integral(signal(InputShape::step), 10), -3 * (10 - start));
      for (InputShape shape : {InputShape::step, InputShape::pulse, InputShape::doublet}) {
        CHECK_EQ(value_at(signal(shape), start), -3.0);
        CHECK_EQ(value_at(signal(shape), start - 1e-9), 0.0);
      }
    }
  }
}

// Between two edges nothing changes; at each something does.
TEST(input_signal_jumps_at_its_edges_alone) {
  for (InputShape shape : {InputShape::step, InputShape::pulse, InputShape::doublet}) {
    const InputSignal<double> s{shape, kControlIndex.pedal, 2, -0.5, 0.75};
    double times[kMaxEdges];
    const int count = edges(s, times);
    CHECK_EQ(count, shape == InputShape::step ? 1 : shape == InputShape::pulse ? 2 : 3);
    int edge = 0;
    for (double t = -2; t < 3; t += kStep) {
      const bool jumps = value_at(s, t) != value_at(s, t - kStep);
      CHECK_EQ(jumps, edge < count && t == times[edge]);
      edge += jumps;
    }
    CHECK_EQ(edge, count);
  }
}

TEST(input_signal_refuses_each_bad_field) {
  const InputSignal<double> good{InputShape::pulse, kControlIndex.pedal, 2, 1, 0.5};
  CHECK(is_valid(good));
  const auto with = [&](auto&& change) {
    InputSignal<double> s = good;
    change(s);
    return is_valid(s);
  };
  for (int control : {0, control_count - 1}) CHECK(with([=](auto& s) { s.control = control; }));
  for (int control : {-1, static_cast<int>(control_count)})
    CHECK(!with([=](auto& s) { s.control = control; }));
  for (double bad : {kNan, kInfinity, -kInfinity}) {
    CHECK(!with([=](auto& s) { s.amplitude = bad; }));
    CHECK(!with([=](auto& s) { s.start = bad; }));
    CHECK(!with([=](auto& s) { s.duration = bad; }));
  }
  for (InputShape shape : {InputShape::pulse, InputShape::doublet}) {
    for (double duration : {0.0, -1.0}) {
      CHECK(!with([=](auto& s) {
        s.shape = shape;
        s.duration = duration;
      }));
    }
    CHECK(with([=](auto& s) {
      s.shape = shape;
      s.duration = 1e-3;
    }));
  }
  // A step lasts: its duration is not read. It may begin before the flight.
  for (double any : {kNan, 0.0, -1.0}) {
    CHECK(with([=](auto& s) {
      s.shape = InputShape::step;
      s.duration = any;
      s.start = -1;
    }));
  }
}
