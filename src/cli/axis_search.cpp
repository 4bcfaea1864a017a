#include "cli/axis_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tiltrotor::cli {

namespace {

constexpr int most_falsi = 60;
constexpr int most_refinements = 30;
constexpr int halvings_to_edge = 6;
constexpr double golden = 0.381966;
constexpr double narrow = 1e-4;      // of a step: no further refinement
constexpr double beside_end = 0.05;  // of the last step: whether the function turns before its end
constexpr double first_growth = 4;

bool is_there(const SearchPoint& p) { return std::isfinite(p.miss); }
double size(const SearchPoint& p) { return std::fabs(p.miss); }
bool differ(const SearchPoint& a, const SearchPoint& b) { return (a.miss > 0) != (b.miss > 0); }

// Lowest point of the parabola through three; not a number where they have none.
double vertex(const SearchPoint& a, const SearchPoint& b, const SearchPoint& c) {
  const double ab = (b.at - a.at) * (size(b) - size(c)), cb = (b.at - c.at) * (size(b) - size(a));
  return b.at - 0.5 * ((b.at - a.at) * ab - (b.at - c.at) * cb) / (ab - cb);
}

}  // namespace

AxisSearch::AxisSearch(const SearchAxis& axis, Evaluate evaluate, std::function<void()> keep)
    : axis_(axis), evaluate_(std::move(evaluate)), keep_(std::move(keep)) {}

bool AxisSearch::run() {
  best_.miss = HUGE_VAL;
  const SearchPoint start = evaluate(axis_.start);
  if (axis_.stops_at_gaps && !is_there(start)) return false;
  for (Side& side : side_) side = {start};
  for (;;) {
    const bool done[2] = {is_exhausted(false) || is_settled(false), is_exhausted(true) || is_settled(true)};
    if (done[0] && done[1]) return found_;
    const bool nearer_up = distance(side_[1].back().at) <= distance(side_[0].back().at);
    extend(done[0] || (!done[1] && nearer_up));
  }
}

// A zero within the tolerance is one wherever it turns up.
SearchPoint AxisSearch::evaluate(double at) {
  const SearchPoint point = evaluate_(at);
  if (!is_there(point)) return point;
  if (size(point) <= axis_.tolerance) take(point);
  if (!found_ && size(point) < size(best_)) best_ = point;
  return point;
}

double AxisSearch::distance(double at) const { return std::fabs(at - axis_.start); }

double AxisSearch::next(double at, bool up) const {
  const double away = distance(at), sign = up ? 1 : -1;
  constexpr double same = 1e-9;
  const double steps = at / axis_.step;
  double point = axis_.step * (up ? std::floor(steps + same) + 1 : std::ceil(steps - same) - 1);
  if (axis_.first > 0 && away < axis_.step) {
    const double near = axis_.start + sign * std::max(axis_.first, first_growth * away);
    if (distance(near) < distance(point)) point = near;
  }
  return std::clamp(point, axis_.low, axis_.high);
}

bool AxisSearch::is_exhausted(bool up) const {
  const double at = side_[up].back().at;
  if (axis_.stops_at_gaps && !is_there(side_[up].back())) return true;
  return up ? at >= axis_.high : at <= axis_.low;
}

// One point beyond the zero, since a turning point is seen from behind.
bool AxisSearch::is_settled(bool up) const {
  if (!found_ || (axis_.choosy && !best_.is_welcome)) return false;
  const Side& side = side_[up];
  const double seen = side.size() < 2 ? 0 : distance(side[side.size() - 2].at);
  return !axis_.choosy || seen >= distance(best_.at);
}

void AxisSearch::extend(bool up) {
  const SearchPoint last = side_[up].back();
  const SearchPoint point = evaluate(next(last.at, up));
  if (is_there(last) && !is_there(point)) find_edge(up, last, point.at);
  if (!is_there(last) && is_there(point)) find_edge(up, point, last.at);
  push(up, point);
  if (is_exhausted(up)) look_at_end(side_[up]);
}

// The function is defined at one point and not at the other.
void AxisSearch::find_edge(bool up, SearchPoint inside, double outside) {
  const bool leaves = distance(outside) > distance(inside.at);
  Side towards = {inside};
  for (int k = 0; k < halvings_to_edge; ++k) {
    const SearchPoint middle = evaluate((towards.back().at + outside) / 2);
    if (is_there(middle)) {
      towards.push_back(middle);
    } else {
      outside = middle.at;
    }
  }
  if (!leaves) std::reverse(towards.begin(), towards.end());
  for (const SearchPoint& point : towards) push(up, point);
  if (leaves) return look_at_end(side_[up]);
  std::reverse(towards.begin(), towards.end());
  look_at_end(towards);
}

void AxisSearch::push(bool up, const SearchPoint& point) {
  Side& side = side_[up];
  const SearchPoint last = side.back();
  if (point.at == last.at) return;
  side.push_back(point);
  if (!is_there(point) || !is_there(last)) return;
  if (differ(point, last)) return close(last, point);
  const Side& other = side_[!up];
  if (side.size() > 2) return refine(side[side.size() - 3], last, point);
  if (other.size() > 1) return refine(other[1], last, point);
  if (is_exhausted(!up)) look_at_end({point, last});
}

// The last step before the range or the function ends.
void AxisSearch::look_at_end(const Side& outward) {
  if (outward.size() < 2) return;
  const SearchPoint last = outward.back(), before = outward[outward.size() - 2];
  if (!is_there(last) || !is_there(before) || differ(last, before) || size(last) > size(before)) return;
  refine(before, evaluate(last.at + beside_end * (before.at - last.at)), last);
}

// The least distance from zero between a and c, where b is nearer to zero than both.
void AxisSearch::refine(SearchPoint a, SearchPoint b, SearchPoint c) {
  if (!is_there(a) || !is_there(b) || !is_there(c) || differ(a, c)) return;
  const bool is_flat = std::max(size(a), size(c)) - size(b) <= axis_.tolerance;
  if (!differ(a, b) && (is_flat || size(b) > size(a) || size(b) > size(c))) return;
  for (int k = 0; k < most_refinements; ++k) {
    if (differ(a, b)) {
      close(a, b);
      return close(b, c);
    }
    const double width = std::fabs(c.at - a.at);
    if (size(b) <= axis_.tolerance || width < narrow * axis_.step) return;
    const double from = std::min(a.at, c.at) + narrow * width, to = std::max(a.at, c.at) - narrow * width;
    const bool beyond = std::fabs(c.at - b.at) > std::fabs(b.at - a.at);
    double at = vertex(a, b, c);
    const bool is_new = at > from && at < to && std::fabs(at - b.at) > narrow * width;
    // Every third step by a part of the larger side, so that both come nearer.
    if (!is_new || k % 3 == 2) at = b.at + golden * ((beyond ? c.at : a.at) - b.at);
    SearchPoint point = evaluate(at);
    if (!is_there(point)) return;
    const bool between_b_and_c = (point.at > b.at) == (c.at > b.at);
    if (differ(point, b)) {
      close(between_b_and_c ? b : a, point);
      return close(point, between_b_and_c ? c : b);
    }
    const bool is_better = size(point) < size(b);
    if (is_better) std::swap(point, b);
    if (between_b_and_c == is_better) {
      a = point;
    } else {
      c = point;
    }
  }
}

// Regula falsi between two of different sign.
void AxisSearch::close(SearchPoint a, SearchPoint b) {
  double weight = 1;
  for (int k = 0; k < most_falsi; ++k) {
    const double miss = weight * a.miss;
    const SearchPoint point = evaluate((a.at * b.miss - b.at * miss) / (b.miss - miss));
    if (!is_there(point) || size(point) <= axis_.tolerance) return;
    if (point.at == a.at || point.at == b.at) {
      if (size(point) <= axis_.jump) take(point);
      return;
    }
    if (differ(point, b)) {
      a = b;
      weight = 1;
    } else {
      weight *= 0.5;
    }
    b = point;
  }
  if (size(b) <= axis_.jump) take(b);
}

void AxisSearch::take(const SearchPoint& zero) {
  if (found_) {
    const bool ranks = axis_.choosy && zero.is_welcome != best_.is_welcome;
    if (ranks ? best_.is_welcome : distance(zero.at) >= distance(best_.at)) return;
  }
  found_ = true;
  best_ = zero;
  keep_();
}

}  // namespace tiltrotor::cli
