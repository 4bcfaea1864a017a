// Rigid body and systems with the rotors away. Expected: the first two terms of the exact A_rr - A_rf (A_ff - s)^-1 A_fr in
// s, by elimination in complex numbers of its own; roots of matrices with a split of slow and fast that is given; without
// systems the bits of rigid_model().
#include <complex>

#include "somewhere.hpp"
#include "tiltrotor/analysis/linear/rigid_outputs.hpp"
#include "tiltrotor/analysis/linear/vehicle_reduction.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"

using namespace vehicle_case;
using Complex = std::complex<double>;

namespace {

constexpr int kStates = kMaxVehicleStates, kInputs = vehicle_input_count;

struct Model {
  VehicleShape shape;
  Matrix<double, kStates, kStates> a;
  Matrix<double, kStates, kInputs> b;
};
VehicleReductionWorkspace<double> work;

void model_of(const Matrices& m, Model& to) {
  to.shape = m.shape;
  for (int i = 0; i < m.shape.states; ++i) {
    for (int j = 0; j < m.shape.states; ++j) to.a(i, j) = m.a[i][j];
    for (int j = 0; j < m.shape.inputs; ++j) to.b(i, j) = m.b[i][j];
  }
}

// Rotors, inflow and wash are fast; said apart from the code under test.
bool is_fast(int state) {
  if (state == kStateIndex.downwash) return true;
  for (const int side : {right, left}) {
    const RotorState<int>& rotor = kStateIndex.rotor[side];
    for (const int of : {rotor.b1c, rotor.b1s, rotor.b1c_rate, rotor.b1s_rate, rotor.lambda_0, rotor.lambda_s,
                         rotor.lambda_c})
      if (state == of) return true;
  }
  return false;
}

// States and inputs of the rows of `of` with the fast states f in (A_ff - s) x_f = -[A_fr B_f]: columns of the slow states,
// in the order of the model, then of the inputs. By Gauss, largest pivot of a column.
std::vector<std::vector<Complex>> followed(const Model& full, const std::vector<std::vector<double>>& of,
                                           Complex s) {
  std::vector<int> slow, fast;
  for (int i = 0; i < full.shape.states; ++i) (is_fast(full.shape.state[i]) ? fast : slow).push_back(i);
  const std::size_t f = fast.size(), r = slow.size(), m = static_cast<std::size_t>(full.shape.inputs);
  std::vector<std::vector<Complex>> t(f, std::vector<Complex>(f + r + m));
  for (std::size_t i = 0; i < f; ++i) {
    for (std::size_t j = 0; j < f; ++j) t[i][j] = full.a(fast[i], fast[j]) - (i == j ? s : 0.0);
    for (std::size_t j = 0; j < r; ++j) t[i][f + j] = -full.a(fast[i], slow[j]);
    for (std::size_t j = 0; j < m; ++j) t[i][f + r + j] = -full.b(fast[i], static_cast<int>(j));
  }
  for (std::size_t k = 0; k < f; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < f; ++i)
      if (std::abs(t[i][k]) > std::abs(t[pivot][k])) pivot = i;
    std::swap(t[k], t[pivot]);
    for (std::size_t i = 0; i < f; ++i) {
      if (i == k) continue;
      const Complex by = t[i][k] / t[k][k];
      for (std::size_t j = k; j < f + r + m; ++j) t[i][j] -= by * t[k][j];
    }
  }
  std::vector<std::vector<Complex>> out;
  for (const std::vector<double>& row : of) {  // over all states, then inputs
    out.emplace_back();
    for (std::size_t j = 0; j < r + m; ++j) {
      Complex sum = j < r ? row[static_cast<std::size_t>(slow[j])]
                          : row[static_cast<std::size_t>(full.shape.states) + j - r];
      for (std::size_t i = 0; i < f; ++i)
        sum += row[static_cast<std::size_t>(fast[i])] * t[i][f + j] / t[i][i];
      out.back().push_back(sum);
    }
  }
  return out;
}

std::vector<std::vector<double>> slow_rows(const Model& full) {
  std::vector<std::vector<double>> rows;
  for (int i = 0; i < full.shape.states; ++i) {
    if (is_fast(full.shape.state[i])) continue;
    rows.emplace_back();
    for (int j = 0; j < full.shape.states; ++j) rows.back().push_back(full.a(i, j));
    for (int j = 0; j < full.shape.inputs; ++j) rows.back().push_back(full.b(i, j));
  }
  return rows;
}

constexpr double kStep = 1e-20;  // of the complex step in s

SystemSwitches everything() {
  SystemSwitches on = with(Governor::pi);
  on.interconnect = true;
  return on;
}

}  // namespace

// (I + d) [A B] of the reduced model is the full one's at s = 0, d the slope of A_rf (A_ff - s)^-1 A_fr there.
TEST(vehicle_reduction_has_the_first_two_terms_in_s) {
  static Model full, first, steady;
  const double flights[][2] = {{0, 20}, {30, 50}, {60, 65}, {90, 100}};
  for (const auto& flight : flights) {
    for (const SystemSwitches& on : {with(Governor::off), with(Governor::pi), everything()}) {
      const Flight f = begun(flight[0], {flight[1], 0, 0, 0}, on);
      const Matrices& m = matrices(f);
      CHECK(m.status == Status::ok);
      model_of(m, full);
      first = steady = full;
      CHECK(reduce_vehicle(Reduction::first_order, first.shape, first.a, first.b, work) == Status::ok);
      const int r = first.shape.states, all = r + first.shape.inputs;
      CHECK_EQ(r, work.kept_count);
      CHECK(r > kRigidStates && work.fast_count > 10 && r + work.fast_count == full.shape.states);
      const auto at = followed(full, slow_rows(full), Complex(0, kStep));
      CHECK(reduce_vehicle(Reduction::quasi_steady, steady.shape, steady.a, steady.b, work) == Status::ok);
      for (int i = 0; i < r; ++i) {
        const auto& row = at[static_cast<std::size_t>(i)];
        double size = 0;
        for (int j = 0; j < all; ++j) size = std::max(size, std::abs(row[static_cast<std::size_t>(j)]));
        for (int j = 0; j < all; ++j) {
          const auto entry = [j, r](const Model& of, int k) { return j < r ? of.a(k, j) : of.b(k, j - r); };
          const Complex expected = row[static_cast<std::size_t>(j)];
          CHECK_NEAR(entry(steady, i), expected.real(), 1e-11 * size);
          double found = entry(first, i), terms = size;
          for (int k = 0; k < r; ++k) {
            const double part = row[static_cast<std::size_t>(k)].imag() / kStep * entry(first, k);
            found -= part;
            terms = std::max(terms, std::fabs(part));
          }
          CHECK_NEAR(found, expected.real(), 1e-10 * terms);
        }
      }
    }
  }
}

// A row of C and D likewise: x_f = (x_f at s = 0) + (its slope in s) x_r', the input's slope left out as in B.
TEST(vehicle_reduction_takes_outputs_along) {
  static Model full, reduced;
  const Flight f = begun(60, {65, 0, 0, 0}, everything());
  model_of(matrices(f), full);
  const int n = full.shape.states, m = full.shape.inputs;
  Dice dice(7);
  constexpr int outputs = 3;
  std::vector<std::vector<double>> rows(outputs);
  for (const Reduction order : {Reduction::first_order, Reduction::quasi_steady}) {
    Matrix<double, outputs, kStates> c;
    Matrix<double, outputs, kInputs> d;
    for (int i = 0; i < outputs; ++i) {
      auto& row = rows[static_cast<std::size_t>(i)];
      row.clear();
      for (int j = 0; j < n; ++j) row.push_back(c(i, j) = dice.between(-1, 1));
      for (int j = 0; j < m; ++j) row.push_back(d(i, j) = dice.between(-1, 1));
    }
    reduced = full;
    CHECK(reduce_vehicle(order, reduced.shape, reduced.a, reduced.b, work) == Status::ok);
    reduce_vehicle_outputs(order, m, work, outputs, c, d);
    const int r = reduced.shape.states;
    const auto at = followed(full, rows, Complex(0, kStep));
    for (int i = 0; i < outputs; ++i)
      for (int j = 0; j < r + m; ++j) {
        const auto& row = at[static_cast<std::size_t>(i)];
        double expected = row[static_cast<std::size_t>(j)].real(), size = std::fabs(expected);
        for (int k = 0; k < r && order == Reduction::first_order; ++k) {
          const double part = row[static_cast<std::size_t>(k)].imag() / kStep *
                              (j < r ? reduced.a(k, j) : reduced.b(k, j - r));
          expected += part;
          size = std::max(size, std::fabs(part));
        }
        CHECK_NEAR(j < r ? c(i, j) : d(i, j - r), expected, 1e-10 * (size + 1));
      }
  }
}

// Fast states twice as fast: the error of a slow root falls by four to first order, by two in balance.
TEST(vehicle_reduction_errors_fall_with_the_order) {
  constexpr int slow = kRigidStates + 3, n = slow + 6;
  static EigenWorkspace<double, kStates> eigen;
  Eigensystem<double, kStates> roots{}, exact{};
  static Model full, reduced;
  VehicleShape shape{};
  for (const int state : kRigidOrder) shape.state[shape.states++] = state;
  const RotorState<int>& rotor = kStateIndex.rotor[right];
  for (const int state :
       {rotor.b1c, rotor.b1s, rotor.lambda_0, rotor.lambda_s, rotor.lambda_c, kStateIndex.downwash})
    shape.state[shape.states++] = state;
  for (const int state : {kSystemIndex.rotor_speed, kSystemIndex.governor, kSystemIndex.power[right]})
    shape.state[shape.states++] = state_count + state;
  CHECK_EQ(shape.states, n);
  Dice dice(11);
  Matrix<double, n, n> of;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) of(i, j) = dice.between(-0.3, 0.3) - (i == j ? 0.4 + 0.15 * i : 0);
  double error[2][3];
  for (int k = 0; k < 3; ++k) {
    const double speed = 40 << k;
    full.shape = shape;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) full.a(i, j) = of(i, j) * (is_fast(shape.state[i]) ? speed : 1);
    CHECK(eigensystem(full.a, n, eigen, exact) == Status::ok);
    for (const Reduction order : {Reduction::first_order, Reduction::quasi_steady}) {
      reduced = full;
      CHECK(reduce_vehicle(order, reduced.shape, reduced.a, reduced.b, work) == Status::ok);
      CHECK_EQ(reduced.shape.states, slow);
      for (int i = 0; i < slow; ++i) CHECK(!is_fast(reduced.shape.state[i]));
      CHECK(eigensystem(reduced.a, slow, eigen, roots) == Status::ok);
      FullRoot<double> known[kStates];
      find_full_roots(exact.values, roots.values, known);
      double worst = 0;
      for (int i = 0; i < slow; ++i) worst = std::max(worst, known[i].error);
      error[order == Reduction::quasi_steady][k] = worst;
    }
  }
  NOTE("first order " << error[0][0] << " " << error[0][1] << " " << error[0][2] << ", balance "
                      << error[1][0] << " " << error[1][1] << " " << error[1][2]);
  for (int k = 0; k < 2; ++k) {
    CHECK_NEAR(error[0][k] / error[0][k + 1], 4, 0.5);
    CHECK_NEAR(error[1][k] / error[1][k + 1], 2, 0.25);
  }
}

TEST(vehicle_reduction_without_systems_has_the_bits_of_the_airframe) {
  static LinearModel<double> model, rigid;
  static RigidModelWorkspace<double> rigid_work;
  static Model full;
  for (int k = 0; k < 3; ++k) {
    const Point p = reference_point(kReferencePoints[k]);
    linear_model(configuration(kReferenceMasts[k]), p.x, p.u, kInceptors, model);
    for (const Reduction order : {Reduction::first_order, Reduction::quasi_steady}) {
      full.shape.states = model.states;
      full.shape.inputs = model.controls;
      for (int i = 0; i < model.states; ++i) {
        full.shape.state[i] = model.state[i];
        for (int j = 0; j < model.states; ++j) full.a(i, j) = model.a(i, j);
        for (int j = 0; j < model.controls; ++j) full.b(i, j) = model.b(i, j);
      }
      CHECK(rigid_model(model, order, rigid_work, rigid) == Status::ok);
      CHECK(reduce_vehicle(order, full.shape, full.a, full.b, work) == Status::ok);
      CHECK(full.shape.states == kRigidStates && full.shape.inputs == model.controls);
      for (int i = 0; i < kRigidStates; ++i) {
        CHECK_EQ(full.shape.state[i], rigid.state[i]);
        for (int j = 0; j < kRigidStates; ++j) CHECK(same_bits(full.a(i, j), rigid.a(i, j)));
        for (int j = 0; j < model.controls; ++j) CHECK(same_bits(full.b(i, j), rigid.b(i, j)));
      }
    }
  }
}

TEST(vehicle_reduction_refuses_what_has_no_balance) {
  static Model full, m;
  const Flight f = begun(30, {50, 0, 0, 0}, with(Governor::pi));
  model_of(matrices(f), full);
  const auto status_of = [&](Reduction order) { return reduce_vehicle(order, m.shape, m.a, m.b, work); };
  const int fast = kRigidStates;
  for (const Reduction order : {Reduction::first_order, Reduction::quasi_steady}) {
    m = full;
    for (int j = 0; j < m.shape.states; ++j) m.a(fast, j) = 0;
    CHECK(status_of(order) == Status::singular);
    CHECK(m.shape.states == 0 && m.shape.inputs == 0);
    m = full;
    m.b(fast + 1, 0) = std::nan("");
    CHECK(status_of(order) == Status::not_finite);
    CHECK_EQ(m.shape.states, 0);
    for (const int column : {1, fast + 1}) {  // A_rr, A_rf
      m = full;
      m.a(2, column) = std::nan("");
      CHECK(status_of(order) == Status::not_finite);
    }
    m = full;
    m.b(2, 0) = std::nan("");
    CHECK(status_of(order) == Status::not_finite);
    m = full;
    m.shape.states = kRigidStates;  // none of them fast
    CHECK(status_of(order) == Status::ok);
    m = full;
    m.shape.states = kRigidStates;
    m.a(2, 1) = std::nan("");
    CHECK(status_of(order) == Status::not_finite);
    // More of a kind than there are: a state that stands there twice.
    m = full;
    for (int i = 0; i < kStates; ++i) m.shape.state[i] = kStateIndex.downwash;
    m.shape.states = kStates;
    CHECK(status_of(order) == Status::bad_argument);
    for (const int states : {-1, 0, kStates + 1}) {
      m = full;
      m.shape.states = states;
      CHECK(status_of(order) == Status::bad_argument);
    }
    m = full;
    m.shape.inputs = kInputs + 1;
    CHECK(status_of(order) == Status::bad_argument);
  }
}
