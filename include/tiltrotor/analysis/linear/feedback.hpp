// A linear feedback law, u = u_0 + v - K (y - y_0), its gains scheduled over mast angle and airspeed, and the linear
// model that it closes.
//
//   linearize(c, x, u, kAllControls, ..., model);  linearize_outputs(..., kAllControls, ...);   // open loop
//   close_controls(law, at, shape, C, D, closed);                                               // u by x and v
//   close_rows(closed, model.states, model.states, model.a, model.b);                           // A - B K ..., B ...
//
// y_0, u_0: of the flight where the law was switched on; v: what the pilot adds. Readings that hang on the controls
// themselves, as accelerations do, are closed exactly: of y = C x + D u, u = (1 + K D)^-1 (v - K C x).
#pragma once

#include "tiltrotor/analysis/flight/instruments.hpp"
#include "tiltrotor/analysis/linear/vehicle_model.hpp"
#include "tiltrotor/math/algebra/lu.hpp"

namespace tiltrotor {

// What a law may read: places of vehicle_variable(), then those of Instruments.
inline constexpr int kReadingCount = vehicle_state_count + Instruments<double>::kCount;
constexpr bool is_instrument(int reading) { return reading >= vehicle_state_count; }

// Gains for one mast angle and airspeed, by rows and columns of the law: unit of the input over that of the reading.
template <class R>
struct GainBlock {
  R mast_deg;
  R speed;  // m/s
  Matrix<R, control_count, kReadingCount> gain;
};

template <class R>
struct FeedbackLaw {
  int inputs, readings;
  int input[control_count];    // row i: place in kControlVariables
  int reading[kReadingCount];  // column k
  const GainBlock<R>* block;   // of the caller, in order of mast angle, then of airspeed
  int blocks;

  bool reads_instruments() const {
    for (int k = 0; k < readings; ++k)
      if (is_instrument(reading[k])) return true;
    return false;
  }
};

// Where the law stands.
template <class R>
struct FeedbackPoint {
  R mast_deg;
  Vec3<R> air;                 // velocity - gust, body axes, m/s; its length counts for the schedule
  R deviation[kReadingCount];  // y - y_0 by the columns of the law
};

namespace feedback_detail {

// A place between neighbours of a rising sequence, held at its ends.
template <class R>
struct Between {
  int low, high;
  R share, slope;  // of `high`, and how it changes
};
template <class R, class At>
Between<R> between(int begin, int end, R x, At&& at) {
  int low = begin;
  while (low + 1 < end && at(low + 1) <= x) ++low;
  if (low + 1 == end || x < at(low)) return {low, low, R(0), R(0)};
  const R slope = R(1) / (at(low + 1) - at(low));
  return {low, low + 1, (x - at(low)) * slope, slope};
}

// Blocks of one mast angle: from `block` to before the one that is returned.
template <class R>
int end_of_mast(const FeedbackLaw<R>& law, int block) {
  int end = block;
  while (end < law.blocks && law.block[end].mast_deg == law.block[block].mast_deg) ++end;
  return end;
}

}  // namespace feedback_detail

// Of the four blocks around a place: how much each counts, and how that changes with airspeed, 1/(m/s), and with mast
// angle, 1/deg.
template <class R>
struct GainShares {
  int block[4];
  R share[4], by_speed[4], by_mast[4];

  R gain(const FeedbackLaw<R>& law, int i, int k) const { return sum(law, i, k, share); }
  R gain_by_speed(const FeedbackLaw<R>& law, int i, int k) const { return sum(law, i, k, by_speed); }
  R gain_by_mast(const FeedbackLaw<R>& law, int i, int k) const { return sum(law, i, k, by_mast); }

 private:
  R sum(const FeedbackLaw<R>& law, int i, int k, const R (&weight)[4]) const {
    R total = R(0);
    for (int b = 0; b < 4; ++b) total += weight[b] * law.block[block[b]].gain(i, k);
    return total;
  }
};

// Linear in airspeed between the blocks of one mast angle, then linear in mast angle; held outside. The law has a block.
template <class R>
GainShares<R> gain_shares(const FeedbackLaw<R>& law, R mast_deg, R speed) {
  using namespace feedback_detail;
  int first = 0;  // of the mast angle at or below
  for (int next = end_of_mast(law, first); next < law.blocks && law.block[next].mast_deg <= mast_deg;)
    next = end_of_mast(law, first = next);
  const int second = end_of_mast(law, first);
  const R low_mast = law.block[first].mast_deg;
  const bool is_between = second < law.blocks && mast_deg >= low_mast;
  const R per_deg = is_between ? R(1) / (law.block[second].mast_deg - low_mast) : R(0);
  const R above = is_between ? (mast_deg - low_mast) * per_deg : R(0);
  GainShares<R> shares;
  for (int m = 0; m < 2; ++m) {
    const int begin = m == 0 || !is_between ? first : second;
    const R weight = m == 0 ? R(1) - above : above, turn = m == 0 ? -per_deg : per_deg;
    const Between<R> at =
        between(begin, end_of_mast(law, begin), speed, [&law](int k) { return law.block[k].speed; });
    shares.block[2 * m] = at.low;
    shares.block[2 * m + 1] = at.high;
    shares.share[2 * m] = weight * (R(1) - at.share);
    shares.share[2 * m + 1] = weight * at.share;
    shares.by_speed[2 * m] = -weight * at.slope;
    shares.by_speed[2 * m + 1] = weight * at.slope;
    shares.by_mast[2 * m] = turn * (R(1) - at.share);
    shares.by_mast[2 * m + 1] = turn * at.share;
  }
  return shares;
}

// Small changes of every control: u = pilot v - gain x, by the order of kControlVariables; behind what the pilot adds to
// them, v holds the inputs that no law moves, which a reading may see: throttles and other commands.
template <class R>
struct ClosedControls {
  static constexpr int kColumns = kMaxVehicleStates + vehicle_input_count;
  int states, inputs;
  Matrix<R, control_count, kColumns> solved;

  R gain(int control, int state) const { return solved(control, state); }
  R pilot(int control, int pilot) const { return solved(control, states + pilot); }
};
template <class R>
struct ClosedControlsWorkspace {
  Matrix<R, control_count, control_count> loop;  // 1 + K D
  LU<R, control_count> lu;
  Matrix<R, control_count, ClosedControls<R>::kColumns> right;
};

// `shape` says which states and inputs the model has, the first inputs those of kAllControls (with none of them no others
// follow); c(i, j), d(i, j): C and D of instrument i, by their columns, asked for where the law reads instruments. Away from y_0 the gains' change with
// airspeed and mast angle counts. Status: ok; singular (the law answers a control with itself: 1 + K D has no inverse); not_finite.
template <class R, class C, class D>
Status close_controls(const FeedbackLaw<R>& law, const FeedbackPoint<R>& at, const VehicleShape& shape, C&& c,
                      D&& d, ClosedControlsWorkspace<R>& work, ClosedControls<R>& closed) {
  const int n = closed.states = shape.states;
  const int inputs = closed.inputs = shape.inputs > control_count ? shape.inputs : control_count;
  const R speed = length(at.air);
  const GainShares<R> shares = gain_shares(law, at.mast_deg, speed);
  work.loop = identity<R, control_count>();
  set_zero(work.right);
  for (int j = 0; j < control_count; ++j) work.right(j, n + j) = R(1);
  const R* const way[] = {&at.air.x, &at.air.y, &at.air.z};
  const int velocity[] = {kStateIndex.velocity.x, kStateIndex.velocity.y, kStateIndex.velocity.z};
  const int gust[] = {kControlIndex.gust.x, kControlIndex.gust.y, kControlIndex.gust.z};
  for (int i = 0; i < law.inputs; ++i) {
    const int row = law.input[i];
    R by_speed = R(0), by_mast = R(0);
    for (int k = 0; k < law.readings; ++k) {
      const R gain = shares.gain(law, i, k);
      by_speed += shares.gain_by_speed(law, i, k) * at.deviation[k];
      by_mast += shares.gain_by_mast(law, i, k) * at.deviation[k] * kDegPerRad<R>;
      const int output = law.reading[k] - vehicle_state_count;
      for (int j = 0; j < n; ++j) {
        if (output >= 0) work.right(row, j) += gain * c(output, j);
        if (shape.state[j] == law.reading[k]) work.right(row, j) += gain;
      }
      for (int j = 0; output >= 0 && j < control_count; ++j) work.loop(row, j) += gain * d(output, j);
      for (int j = control_count; output >= 0 && j < inputs; ++j)
        work.right(row, n + j) -= gain * d(output, j);
    }
    for (int j = 0; j < n; ++j)
      if (shape.state[j] == state_count + kSystemIndex.mast) work.right(row, j) += by_mast;
    for (int axis = 0; axis < 3 && by_speed != R(0); ++axis) {
      for (int j = 0; j < n; ++j)
        if (shape.state[j] == velocity[axis]) work.right(row, j) += by_speed * *way[axis] / speed;
      work.loop(row, gust[axis]) -= by_speed * *way[axis] / speed;
    }
  }
  const Status status = lu_factor(work.loop, control_count, work.lu);
  return status == Status::ok ? lu_solve(work.lu, work.right, n + inputs, closed.solved) : status;
}

// Rows of xdot = A x + B u, or of y = C x + D u, become those of the closed loop, with v in the place of u. Columns of `b`
// are those of the shape.
template <class R, class A, class B>
void close_rows(const ClosedControls<R>& closed, int rows, int states, A& a, B& b) {
  for (int i = 0; i < rows; ++i) {
    R by_control[control_count];
    for (int l = 0; l < control_count; ++l) by_control[l] = b(i, l);
    for (int j = 0; j < states; ++j)
      for (int l = 0; l < control_count; ++l) a(i, j) -= by_control[l] * closed.gain(l, j);
    for (int v = 0; v < closed.inputs; ++v) {
      R sum = v < control_count ? R(0) : b(i, v);
      for (int l = 0; l < control_count; ++l) sum += by_control[l] * closed.pilot(l, v);
      b(i, v) = sum;
    }
  }
}

}  // namespace tiltrotor
