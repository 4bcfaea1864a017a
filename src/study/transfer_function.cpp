#include "study/transfer_function.hpp"

#include <cmath>
#include <vector>

#include "text/number.hpp"
#include "text/split.hpp"

namespace tiltrotor::study {

// By elimination with row pivoting.
Complex response_of(const Linear& model, int output, int input, double omega, bool derivative) {
  const int n = model.states;
  const Complex s(0, omega);
  std::vector<std::vector<Complex>> m(static_cast<std::size_t>(n),
                                      std::vector<Complex>(static_cast<std::size_t>(n + 1)));
  int column = 0;
  while (model.control[column] != input) ++column;
  const auto at = [&m](int i, int j) -> Complex& {
    return m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) at(i, j) = (i == j ? s : Complex(0)) - model.a(i, j);
    at(i, n) = model.b(i, column);
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i) {
      if (std::abs(at(i, k)) > std::abs(at(pivot, k))) pivot = i;
    }
    std::swap(m[static_cast<std::size_t>(k)], m[static_cast<std::size_t>(pivot)]);
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const Complex factor = at(i, k) / at(k, k);
      for (int j = k; j <= n; ++j) at(i, j) -= factor * at(k, j);
    }
  }
  int row = 0;
  while (model.state[row] != output) ++row;
  const Complex x = at(row, n) / at(row, row);
  return derivative ? s * x : x;
}

Complex polynomial(const std::string& coefficients, Complex s) {
  Complex value = 0;
  for (const std::string& c : text::split(coefficients, ' '))
    value = value * s + text::parse_number(c, "transfer function");
  return value;
}

double leading_coefficient(const std::string& coefficients) {
  return text::parse_number(text::split(coefficients, ' ').front(), "transfer function");
}

double decibel(Complex value) { return 20 * std::log10(std::abs(value)); }

double phase_deg(Complex value) { return degrees(std::arg(value)); }

double nearest_turn(double phase, double to) { return phase + 360 * std::round((to - phase) / 360); }

}  // namespace tiltrotor::study
