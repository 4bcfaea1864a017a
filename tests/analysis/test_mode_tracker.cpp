// Branches along sweeps. Expected values: a number stands for one branch, so it is kept where a model continues the one
// before and is new where it does not; follow() says which mode continues which.
#include <limits>
#include <set>

#include "analysis_case.hpp"
#include "tiltrotor/analysis/linear/mode_tracker.hpp"

using namespace analysis_case;

namespace {

std::set<int> branches(const ModeSet<double>& set) {
  std::set<int> numbers;
  for (int i = 0; i < set.count; ++i) numbers.insert(set.mode[i].branch);
  return numbers;
}

}  // namespace

TEST(modes_tracker_numbers_each_branch_once) {
  static ModeTracker<double> tracker;
  static LinearModel<double> slow, fast;
  static ModeSet<double> previous, set;
  const Configuration<double> c = configuration(90);
  const TrimResult<double> a = trimmed(c, level(100));
  const TrimResult<double> b = trimmed(c, level(101));
  linear_model(c, a.state, a.controls, kInceptors, slow);
  linear_model(c, b.state, b.controls, kInceptors, fast);
  modes_of(c, a.state, a.controls, previous);
  modes_of(c, b.state, b.controls, set);
  CHECK(follow(previous, set) == Status::ok);

  // The first of a sweep begins at one; what continues it has the branches of follow().
  CHECK(tracker.find(slow, true) == Status::ok);
  const int count = tracker.found().count;
  CHECK_EQ(*branches(tracker.found()).begin(), 1);
  CHECK_EQ(*branches(tracker.found()).rbegin(), count);
  CHECK(tracker.find(fast, true) == Status::ok);
  CHECK_EQ(tracker.found().count, set.count);
  for (int i = 0; i < set.count; ++i) CHECK_EQ(tracker.found().mode[i].branch, set.mode[i].branch);
  CHECK_EQ(tracker.found().branches, set.branches);

  // What does not continue it has none of the numbers before, nor has what follows a flight without modes.
  CHECK(tracker.find(slow, false) == Status::ok);
  CHECK_EQ(*branches(tracker.found()).begin(), set.branches + 1);
  tracker.lose_track();
  CHECK(tracker.find(fast, true) == Status::ok);
  CHECK_EQ(*branches(tracker.found()).begin(), set.branches + count + 1);
  static LinearModel<double> broken;
  broken = slow;
  broken.a(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK(tracker.find(broken, true) == Status::not_finite);
  CHECK(tracker.find(slow, true) == Status::ok);
  CHECK_EQ(*branches(tracker.found()).begin(), set.branches + 2 * count + 1);

  // Another sweep begins at one again.
  tracker.begin_sweep();
  CHECK(tracker.find(slow, true) == Status::ok);
  CHECK_EQ(*branches(tracker.found()).begin(), 1);
  CHECK_EQ(tracker.found().branches, count);
}
