// Where a function of one variable is zero, nearest to a start: for functions that are not defined everywhere, turn
// round, jump, and whose zeros are not all welcome.
//
// Outward from the start on both sides, along points of a grid that does not depend on it. Between neighbours of
// different sign a zero is closed in by regula falsi (Illinois). Where the distance from zero has a least value among
// three neighbours, at an end of the range, or at the edge of where the function is defined, that is refined before
// anything is said of it: two zeros may lie between points of the grid. Bounded: two points a step of the grid at most,
// and at each turning point or edge some thirty more.
#pragma once

#include <functional>
#include <vector>

namespace tiltrotor::cli {

struct SearchAxis {
  double low, high;  // ends of the range
  double step;       // of the grid
  double start;
  double first;  // distance of the first points from the start, growing to the grid's; 0: the grid at once
  double tolerance;    // of the function at a zero
  double jump;         // what may be left of it where it is not continuous
  bool choosy;         // a zero that is not welcome only where there is no other
  bool stops_at_gaps;  // nothing is looked for beyond where the function is not defined
};

struct SearchPoint {
  double at;
  double miss;      // the function; not a number where it is not defined
  bool is_welcome;  // as a zero
};

class AxisSearch {
 public:
  // `keep`: the point evaluated last is the best zero so far.
  using Evaluate = std::function<SearchPoint(double at)>;
  AxisSearch(const SearchAxis& axis, Evaluate evaluate, std::function<void()> keep);

  // Whether there is a zero: best() is then the one kept; else the point found nearest to zero.
  bool run();
  const SearchPoint& best() const { return best_; }

 private:
  using Side = std::vector<SearchPoint>;  // outward, the start first

  SearchPoint evaluate(double at);
  double distance(double at) const;
  double next(double at, bool up) const;
  bool is_exhausted(bool up) const;
  bool is_settled(bool up) const;
  void extend(bool up);
  void find_edge(bool up, SearchPoint inside, double outside);
  void push(bool up, const SearchPoint& point);
  void look_at_end(const Side& outward);
  void refine(SearchPoint a, SearchPoint b, SearchPoint c);
  void close(SearchPoint a, SearchPoint b);
  void take(const SearchPoint& zero);

  SearchAxis axis_;
  Evaluate evaluate_;
  std::function<void()> keep_;
  Side side_[2];  // down and up
  SearchPoint best_{};
  bool found_ = false;
};

}  // namespace tiltrotor::cli
