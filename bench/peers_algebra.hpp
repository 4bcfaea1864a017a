// Our eigenvalues and linear solutions beside those of another library, on the same matrices.
#pragma once

#include <memory>
#include <string>

#include "flights.hpp"
#include "machine.hpp"
#include "matrices.hpp"
#include "results.hpp"

namespace bench {

// Peer<N>(const MatrixSet<N>&) has find_values(), find_vectors(), solve() and x, as OurAlgebra<N>.
template <template <int> class Peer, int N>
void compare_algebra(const std::string& peer_name, Results& results) {
  static MatrixSet<N> set;
  fill_at_random(set);
  const auto ours = std::make_unique<OurAlgebra<N>>(set);
  const auto peer = std::make_unique<Peer<N>>(set);
  Contest contest;
  const int our_values = contest.enter("eigenvalues", [&] { ours->find_values(); });
  const int peer_values = contest.enter("eigenvalues", [&] { peer->find_values(); });
  const int our_vectors = contest.enter("eigensystem", [&] { ours->find_vectors(); });
  const int peer_vectors = contest.enter("eigensystem", [&] { peer->find_vectors(); });
  const int our_lu = contest.enter("LU", [&] { ours->solve(); });
  const int peer_lu = contest.enter("LU", [&] { peer->solve(); });
  contest.run();
  require(ours->ok && peer->ok, "a random matrix failed");
  const std::string n = "_n" + std::to_string(N);
  const std::string over = n + "_over_" + peer_name;
  results.add("eigenvalues" + over, contest.ratio(our_values, peer_values), "-");
  results.add("eigensystem" + over, contest.ratio(our_vectors, peer_vectors), "-");
  results.add("lu" + over, contest.ratio(our_lu, peer_lu), "-");
}

template <template <int> class Peer>
void compare_algebra(const std::string& peer_name, Results& results) {
  compare_algebra<Peer, 9>(peer_name, results);
  compare_algebra<Peer, 12>(peer_name, results);
  compare_algebra<Peer, 23>(peer_name, results);
  compare_algebra<Peer, 31>(peer_name, results);
}

}  // namespace bench
