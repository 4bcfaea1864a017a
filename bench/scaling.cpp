// How cost grows with the number of blade elements and with the number of seeds (columns of the Jacobian).
#include <cmath>
#include <memory>
#include <sstream>

#include "flights.hpp"
#include "machine.hpp"
#include "results.hpp"

using namespace bench;

namespace {

struct Measured {
  double size;
  double seconds;
};

// Slope of log(time) over log(size), by least squares.
double exponent(const std::vector<Measured>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Measured& p : points) {
    const double a = std::log(p.size);
    const double b = std::log(p.seconds);
    n += 1;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

// Seconds per unit of size between the smallest and the largest.
double marginal(const std::vector<Measured>& points) {
  return (points.back().seconds - points.front().seconds) / (points.back().size - points.front().size);
}

void list(std::ostringstream& csv, const char* what, const std::vector<Measured>& points) {
  for (const Measured& p : points) {
    csv << what << ',' << number(p.size) << ',' << number(1e6 * p.seconds) << '\n';
    std::printf("  %-24s %8.0f %12.3f us\n", what, p.size, 1e6 * p.seconds);
  }
}

// Elements: by azimuth stations, 20 elements each, two rotors.
constexpr int kAzimuths[] = {8, 16, 24, 48, 72};  // whole vectors of blades on every target
constexpr int kAzimuthCount = static_cast<int>(sizeof kAzimuths / sizeof kAzimuths[0]);

void over_elements(Results& results, std::ostringstream& csv) {
  struct Case {
    Configuration<double> c;
    TrimResult<double> flight;
  };
  std::vector<Case> cases;
  for (int stations : kAzimuths) {
    Options options;
    options.azimuth_stations = stations;
    const Configuration<double> c = configuration(kMiddleMast, options);
    cases.push_back({c, trimmed(c, kMiddleSpeed)});
  }
  const auto work = std::make_unique<LinearizationWorkspace<double, AutoDiff>>();
  LinearModel<double> model;
  State<double> rates;
  Contest contest;
  for (const Case& k : cases)
    contest.enter("f", [&] { derivative(k.c, k.flight.state, k.flight.controls, rates); });
  for (const Case& k : cases)
    contest.enter("A, B", [&] {
      require(linearize(k.c, k.flight.state, k.flight.controls, kBladeControls, *work, model) == Status::ok,
              "A, B");
    });
  contest.run();

  std::vector<Measured> plain, exact;
  for (int k = 0; k < kAzimuthCount; ++k) {
    const double size = elements(cases[static_cast<std::size_t>(k)].c);
    plain.push_back({size, contest.time(k).median});
    exact.push_back({size, contest.time(kAzimuthCount + k).median});
  }
  list(csv, "function_elements", plain);
  list(csv, "jacobian_elements", exact);
  results.add("scaling_exponent_function_elements", exponent(plain), "-");
  results.add("scaling_exponent_jacobian_elements", exponent(exact), "-");
  results.add("element_marginal_ns", 1e9 * marginal(plain), "ns");
  results.add("element_marginal_jacobian_ns", 1e9 * marginal(exact), "ns");
}

// One evaluation of the model on N partials: N columns of the Jacobian.
template <int N>
int enter_seeds(Contest& contest, const Configuration<double>& c, const TrimResult<double>& flight) {
  using D = Dual<double, N>;
  static ModelWorkspace<D> work;
  return contest.enter("seeds", [&c, &flight] {
    double x[state_count];
    double u[control_count];
    flatten(flight.state, x);
    flatten(flight.controls, u);
    const ActiveStates active = active_states(c.setup.options, false);
    const ModelPlaces<D> at(work);
    for (int i = 0; i < state_count; ++i) *at.x[i] = x[i];
    for (int j = 0; j < control_count; ++j) *at.u[j] = u[j];
    for (int k = 0; k < N && k < active.count; ++k) at.x[active.index[k]]->d.set(k, 1);
    for (int k = active.count; k < N && k < active.count + control_count; ++k)
      at.u[k - active.count]->d.set(k, 1);
    model_rates(c, 0.0, work);
  });
}

template <int... N>
void over_seeds(Results& results, std::ostringstream& csv) {
  const Configuration<double> c = configuration(kMiddleMast);
  const TrimResult<double> flight = trimmed(c, kMiddleSpeed);
  Contest contest;
  const int seeds[] = {N...};
  const int entered[] = {enter_seeds<N>(contest, c, flight)...};
  contest.run();
  std::vector<Measured> points;
  for (std::size_t k = 0; k < sizeof...(N); ++k)
    points.push_back({static_cast<double>(seeds[k]), contest.time(entered[k]).median});
  list(csv, "seeds", points);
  results.add("scaling_exponent_seeds", exponent(points), "-");
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_scaling DIRECTORY");
  introduce("Growth of cost with blade elements (f, and A with B) and with seeds (one pass of dual numbers)");
  Results results(argv[1]);
  std::ostringstream csv;
  csv << "what,size,time_us\n";
  over_elements(results, csv);
  over_seeds<4, 8, 16, 24, 32, 48>(results, csv);
  results.write("scaling.csv", csv.str());
  results.save();
}
