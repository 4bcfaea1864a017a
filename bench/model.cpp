// One evaluation of the model, one blade element, and the full A and B against it.
#include <memory>

#include "flights.hpp"
#include "machine.hpp"
#include "results.hpp"

using namespace bench;

namespace {

using AutoWork = LinearizationWorkspace<double, AutoDiff>;
using NumWork = LinearizationWorkspace<double, NumDiff>;

struct Columns {
  const char* suffix;
  const ControlSet* set;
};
// Pass of 32 directions: blade controls (7) and inceptors (4) beside 23 states fit, all 14 inputs need a
// second pass.
constexpr Columns kColumns[] = {
    {"", &kBladeControls}, {"_inceptors", &kInceptors}, {"_all_inputs", &kAllControls}};

void measure(const Grid& grid, Results& results) {
  const Configuration<double> c = configuration(kMiddleMast, with_grid(grid.grid));
  const TrimResult<double> flight = trimmed(c, kMiddleSpeed);
  const auto auto_work = std::make_unique<AutoWork>();
  const auto num_work = std::make_unique<NumWork>();
  LinearModel<double> model;
  State<double> rates;

  Contest contest;
  const int plain = contest.enter("f", [&] { derivative(c, flight.state, flight.controls, rates); });
  int exact[3];
  for (int k = 0; k < 3; ++k) {
    exact[k] = contest.enter("A, B", [&, k] {
      require(linearize(c, flight.state, flight.controls, *kColumns[k].set, *auto_work, model) == Status::ok,
              "A, B");
    });
  }
  const int numerical = contest.enter("A, B by differences", [&] {
    require(linearize(c, flight.state, flight.controls, kBladeControls, *num_work, model) == Status::ok,
            "A, B");
  });
  contest.run();

  std::printf("\n %s grid: %d elements\n", grid.name, elements(c));
  const std::string s = grid.suffix;
  results.add("elements" + s, elements(c), "-");
  results.add("function_us" + s, contest.time(plain), "us", 1e6);
  results.add("element_ns" + s, contest.time(plain), "ns", 1e9 / elements(c));
  results.add("jacobian_us" + s, contest.time(exact[0]), "us", 1e6);
  for (int k = 0; k < 3; ++k)
    results.add(std::string("jacobian_over_function") + kColumns[k].suffix + s,
                contest.ratio(exact[k], plain), "-");
  results.add("jacobian_over_function_nd" + s, contest.ratio(numerical, plain), "-");
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_model DIRECTORY");
  introduce(
      "Model: f(x, u), and A (23 x 23) with B (23 x 7) over it; element_ns is f over its elements, airframe "
      "included");
  Results results(argv[1]);
  for (const Grid& grid : kGrids) measure(grid, results);
  results.save();
}
