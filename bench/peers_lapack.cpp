// Eigenvalues and linear systems with LAPACK: dgeev, dgesv, whichever implementation is installed.
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "peers_algebra.hpp"

extern "C" {
void dgeev_(const char* left, const char* right, const int* n, double* a, const int* stride, double* real,
            double* imag, double* vl, const int* stride_l, double* vr, const int* stride_r, double* work,
            const int* work_size, int* info, std::size_t, std::size_t);
void dgesv_(const int* n, const int* columns, double* a, const int* stride, int* pivot, double* b,
            const int* stride_b, int* info);
void ilaver_(int* major, int* minor, int* patch);
}

using namespace bench;

namespace {

template <int N>
struct LapackAlgebra {
  static constexpr int kWork = 64 * N;
  double matrix[kMatrices][N * N];  // by columns
  double b[N], x[N];
  double a[N * N], real[N], imag[N], left[N * N], right[N * N], work[kWork];
  int pivot[N];
  int turn = 0;
  bool ok = true;

  explicit LapackAlgebra(const MatrixSet<N>& set) {
    for (int k = 0; k < kMatrices; ++k)
      for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) matrix[k][j * N + i] = set.a[k](i, j);
    std::memcpy(b, set.b, sizeof b);
  }
  void eigen(const char* vectors) {
    std::memcpy(a, matrix[next(turn)], sizeof a);
    const int n = N;
    const int size = kWork;
    int info = 0;
    dgeev_(vectors, vectors, &n, a, &n, real, imag, left, &n, right, &n, work, &size, &info, 1, 1);
    ok = ok && info == 0;
  }
  void find_values() { eigen("N"); }
  void find_vectors() { eigen("V"); }
  void solve() {
    std::memcpy(a, matrix[next(turn)], sizeof a);
    std::memcpy(x, b, sizeof x);
    const int n = N;
    const int one = 1;
    int info = 0;
    dgesv_(&n, &one, a, &n, pivot, x, &n, &info);
    ok = ok && info == 0;
  }
};

// Largest distance of one of our eigenvalues to the nearest of dgeev's, over the norm of the matrix.
template <int N>
double largest_difference() {
  static MatrixSet<N> set;
  fill_at_random(set);
  const auto ours = std::make_unique<OurAlgebra<N>>(set);
  const auto peer = std::make_unique<LapackAlgebra<N>>(set);
  double worst = 0;
  for (int k = 0; k < kMatrices; ++k) {
    ours->find_values();
    peer->find_values();
    double norm = 0;
    for (double x : peer->matrix[peer->turn]) norm += x * x;
    for (int i = 0; i < N; ++i) {
      double nearest = norm;
      for (int j = 0; j < N; ++j) {
        const std::complex<double> d(ours->values.real[i] - peer->real[j],
                                     ours->values.imag[i] - peer->imag[j]);
        nearest = std::min(nearest, std::abs(d));
      }
      worst = std::max(worst, nearest / std::sqrt(norm));
    }
  }
  return worst;
}

// Which library answers to a name: the ratios belong to that build alone.
void say_where(const char* function) {
  Dl_info where{};
  void* const found = dlsym(RTLD_DEFAULT, function);
  char* const path =
      found != nullptr && dladdr(found, &where) != 0 ? realpath(where.dli_fname, nullptr) : nullptr;
  std::printf("  %-8s from %s\n", function, path != nullptr ? path : "this program");
  std::free(path);
}

}  // namespace

int main(int argc, char** argv) {
  require(argc == 2, "usage: bench_peers_lapack DIRECTORY");
  introduce("Peer: LAPACK dgeev (eigensystem: right and left vectors, as ours) and dgesv");
  int version[3] = {};
  ilaver_(&version[0], &version[1], &version[2]);
  std::printf("  LAPACK %d.%d.%d\n", version[0], version[1], version[2]);
  say_where("dgeev_");
  say_where("dgemm_");
  Results results(argv[1]);
  compare_algebra<LapackAlgebra>("lapack", results);
  results.add("eigenvalues_n9_difference_lapack", largest_difference<9>(), "-");
  results.add("eigenvalues_n23_difference_lapack", largest_difference<23>(), "-");
  results.add("eigenvalues_n31_difference_lapack", largest_difference<31>(), "-");
  results.save();
}
