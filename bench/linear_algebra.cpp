// Eigenvalues, eigenvectors and linear systems of the sizes the analyses need.
#include <memory>

#include "flights.hpp"
#include "machine.hpp"
#include "matrices.hpp"
#include "results.hpp"

using namespace bench;

namespace {

template <int N>
void measure(Results& results) {
  static MatrixSet<N> set;
  fill_at_random(set);
  const auto algebra = std::make_unique<OurAlgebra<N>>(set);
  Contest contest;
  const int values = contest.enter("eigenvalues", [&] { algebra->find_values(); });
  const int vectors = contest.enter("eigensystem", [&] { algebra->find_vectors(); });
  const int lu = contest.enter("LU", [&] { algebra->solve(); });
  contest.run();
  require(algebra->ok, "a random matrix failed");
  const std::string n = "_n" + std::to_string(N) + "_us";
  results.add("eigenvalues" + n, contest.time(values), "us", 1e6);
  results.add("eigensystem" + n, contest.time(vectors), "us", 1e6);
  results.add("lu" + n, contest.time(lu), "us", 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_linear_algebra DIRECTORY");
  introduce(
      "Linear algebra: eigenvalues; with right and left vectors and conditions; LU factors and one solution");
  Results results(argv[1]);
  measure<9>(results);
  measure<12>(results);
  measure<23>(results);
  measure<31>(results);
  results.save();
}
