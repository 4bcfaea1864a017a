// One computation on batches: elementary functions, choices and table look-ups, with slopes. Compiled twice,
// with the compiler's vector types and with portable lanes; whoever includes this says which by then.
#include <vector>

#include "tiltrotor/math/smooth.hpp"
#include "tiltrotor/math/tables/table.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"

namespace batch_program {

using tiltrotor::Batch;
using tiltrotor::Dual;
using tiltrotor::Interpolation;
using tiltrotor::Real;

// A table over two axes, the first with the index that a generator would write.
template <class R>
struct SampleTable {
  R x[5] = {R(-1), R(0), R(1), R(2), R(4)};
  unsigned char bucket[6] = {0, 1, 2, 3, 3, 3};
  R y[3] = {R(0), R(0.5), R(2)};
  R node[60] = {};
  tiltrotor::Table<R, 2> table{};

  SampleTable() {
    for (int i = 0; i < 15; ++i) node[4 * i] = static_cast<R>((i * 7) % 11) - R(5);
    table.smooth[0] = {5, x, bucket, R(1)};
    table.smooth[1] = {3, y};
    table.node = node;
    R scratch[60];
    tiltrotor::fill_slopes<R, 2>(table.smooth, node, scratch);
  }
};

template <class T>
T formula(const SampleTable<Real<T>>& sample, Interpolation mode, const T& a, const T& b) {
  using R = Real<T>;
  using tiltrotor::atan2;
  using tiltrotor::cos;
  using tiltrotor::sin;
  using tiltrotor::smooth_step;
  using tiltrotor::sqrt;
  using tiltrotor::wrapped_difference;
  const T length = sqrt(T(a * a + b * b + R(0.01)));
  const T angle = wrapped_difference(T(R(3) * a), atan2(b, a));
  const T switched = smooth_step(T(R(0.5) * a)) * sin(angle) - cos(T(R(20) * b)) / length;
  return switched + lookup(sample.table, mode, T(R(2) * a), b) * (-angle);
}

// Arguments: a grid of points that meets every quadrant, the edges of the table and beyond.
constexpr int kPoints = 96;
template <class R>
R first(int i) {
  return static_cast<R>(i % 12) * R(0.25) - R(0.75);
}
template <class R>
R second(int i) {
  return static_cast<R>(i / 12) * R(0.4) - R(0.8) + static_cast<R>(i % 5) * R(0.011);
}

// Value and two slopes at every point, both modes.
template <class R>
std::vector<R> batch_results() {
  using D = Dual<Batch<R>, 2>;
  const SampleTable<R> sample;
  std::vector<R> out;
  for (const Interpolation mode : {Interpolation::c1, Interpolation::linear}) {
    for (int i = 0; i < kPoints; i += Batch<R>::kLanes) {
      Batch<R> a;
      Batch<R> b;
      for (int lane = 0; lane < Batch<R>::kLanes; ++lane) {
        a.set(lane, first<R>(i + lane));
        b.set(lane, second<R>(i + lane));
      }
      const D f = formula(sample, mode, D::variable(a, 0), D::variable(b, 1));
      const Batch<R> plain = formula(sample, mode, a, b);
      for (int lane = 0; lane < Batch<R>::kLanes; ++lane) {
        for (const R x : {plain.get(lane), f.v.get(lane), f.d.get(0).get(lane), f.d.get(1).get(lane)})
          out.push_back(x);
      }
    }
  }
  return out;
}

}  // namespace batch_program
