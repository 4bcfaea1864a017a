// The search along one axis that `trim --hold` uses. Expected: zeros and turning points of functions known in closed form.
#include <cmath>

#include "check.hpp"
#include "cli/axis_search.hpp"

using tiltrotor::cli::AxisSearch;
using tiltrotor::cli::SearchAxis;
using tiltrotor::cli::SearchPoint;

namespace {

struct Found {
  bool is_zero;
  SearchPoint best;
  double kept;
  int evaluations;
};

bool always(double) { return true; }

// In -90..90 with steps of 2.
Found search(double start, double (*f)(double), bool (*is_welcome)(double) = always, double low = -90) {
  const SearchAxis axis = {low, 90, 2, start, 0, 1e-10, 1e-6, true, false};
  Found found{false, {}, std::nan(""), 0};
  double last = std::nan("");
  AxisSearch along(
      axis,
      [&](double at) -> SearchPoint {
        ++found.evaluations;
        last = at;
        return {at, f(at), is_welcome(at)};
      },
      [&] { found.kept = last; });
  found.is_zero = along.run();
  found.best = along.best();
  return found;
}

}  // namespace

// Two zeros between neighbouring points of the grid, whatever the start; the nearer one.
TEST(cli_trim_search_finds_zeros_between_its_points) {
  const auto f = [](double x) { return (x - 3.3) * (x - 3.3) - 0.01; };
  for (double start = -90; start <= 90; start += 7.3) {
    const Found found = search(start, f);
    if (!CHECK(found.is_zero)) NOTE("from " << start);
    CHECK_NEAR(found.best.at, start < 3.3 ? 3.2 : 3.4, 1e-8);
    CHECK_EQ(found.kept, found.best.at);
    CHECK_LT(found.evaluations, 200);
  }
  const auto below = [](double x) { return 0.01 - (x - 3.3) * (x - 3.3); };
  CHECK_NEAR(search(50, below).best.at, 3.4, 1e-8);
  const auto touches = [](double x) { return (x - 3.3) * (x - 3.3) * (1 + 0.01 * x); };
  CHECK_NEAR(search(50, touches).best.at, 3.3, 1e-4);
}

// Two between the last point and the end of the range, or the edge of where the function is defined.
TEST(cli_trim_search_looks_at_ends_and_edges) {
  const auto at_end = [](double x) { return (x + 89.5) * (x + 89.5) - 0.01; };
  CHECK_NEAR(search(0, at_end).best.at, -89.4, 1e-8);
  CHECK_NEAR(search(-90, at_end).best.at, -89.6, 1e-8);
  const auto beside_edge = [](double x) { return std::sqrt(x - 7.7) - 0.3; };
  for (const double start : {-20.0, 7.0, 8.0, 40.0}) {
    const Found found = search(start, beside_edge);
    if (!CHECK(found.is_zero)) NOTE("from " << start);
    CHECK_NEAR(found.best.at, 7.79, 1e-8);
  }
}

// Zeros of the sine: the nearest welcome one; another only where no one is.
TEST(cli_trim_search_prefers_welcome_zeros) {
  const double pi = std::acos(-1.0);
  const auto sine = [](double x) { return std::sin(x / 5); };
  CHECK_NEAR(search(12, sine).best.at, 5 * pi, 1e-8);
  const Found far = search(12, sine, [](double x) { return x > 20 || x < -80; });
  CHECK_NEAR(far.best.at, 10 * pi, 1e-8);
  CHECK(far.best.is_welcome);
  const Found none = search(12, sine, [](double) { return false; });
  CHECK(none.is_zero && !none.best.is_welcome);
  CHECK_NEAR(none.best.at, 5 * pi, 1e-8);
}

// What is not there is not claimed; the nearest is the turning point itself.
TEST(cli_trim_search_says_how_near_it_came) {
  for (const double start : {-60.0, 2.0, 3.3, 81.0}) {
    const Found found = search(start, [](double x) { return std::cosh((x - 3.3) / 20) - 0.75; });
    CHECK(!found.is_zero);
    CHECK_NEAR(found.best.miss, 0.25, 1e-9);
    CHECK_NEAR(found.best.at, 3.3, 1e-3);
    CHECK_LT(found.evaluations, 200);
  }
  const Found jump = search(0, [](double x) { return x < 5.1 ? -1.0 : 1.0 + x; });
  CHECK(!jump.is_zero);
  CHECK_LT(jump.evaluations, 300);
  const Found nothing = search(0, [](double) { return std::nan(""); });
  CHECK(!nothing.is_zero && !std::isfinite(nothing.best.miss));
}
