// Values of interpolation tables in one to four dimensions, inside and at the ends, against the textbook formulas of
// table_sample.hpp.
#include "table_sample.hpp"

using namespace table_sample;

// ---- values ----

TEST(table_linear_agrees_with_multilinear_formula) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const Sample<1, 0> s1(random, {5});
    const Sample<2, 0> s2(random, {4, 6});
    const Sample<1, 1> s11(random, {3, 5});
    const Sample<2, 1> s21(random, {3, 4, 5});
    const Sample<1, 2> s12(random, {2, 4, 5});
    const Sample<3, 1> s31(random, {3, 4, 3, 5});
    const Sample<2, 2> s22(random, {3, 2, 4, 5});
    const auto check = [&](const auto& s, double actual, const Numbers& x) {
      CHECK_NEAR(actual, multilinear(all_axes(s), s.value, x), 1e-14);
    };
    const auto without_linear = [&](const auto& s) {
      const Numbers x = arguments(random, s.smooth);
      check(s, look(s, Interpolation::linear, x), x);
    };
    const auto with_linear = [&](const auto& s) {
      const Numbers x = arguments(random, s.smooth);
      const Numbers p = arguments(random, s.linear);
      check(s, look(s, Interpolation::linear, x, p), joined(p, x));
    };
    without_linear(s1);
    without_linear(s2);
    with_linear(s11);
    with_linear(s21);
    with_linear(s12);
    with_linear(s31);
    with_linear(s22);
  }
}

TEST(table_c1_agrees_with_textbook_hermite) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    for (const int count : {2, 3, 7}) {
      const Sample<1, 0> s(random, {count});
      const Numbers x = arguments(random, s.smooth);
      CHECK_NEAR(look(s, Interpolation::c1, x),
                 hermite(s.smooth[0], s.value, slopes(s.smooth[0], s.value), x[0]), 1e-13);
    }
    for (const std::vector<int>& counts : {std::vector<int>{4, 5}, {2, 3}, {6, 1}, {1, 4}}) {
      const Sample<2, 0> s(random, counts);
      const Numbers x = arguments(random, s.smooth);
      CHECK_NEAR(look(s, Interpolation::c1, x), nested_hermite(s.smooth[0], s.smooth[1], s.value, x[0], x[1]),
                 1e-13);
    }
  }
}

// With linear axes: the blend of the blocks, each a table of its own.
TEST(table_c1_blends_blocks_along_linear_axes) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const Sample<2, 2> s(random, {3, 4, 4, 5});
    const Numbers x = arguments(random, s.smooth);
    const Numbers p = arguments(random, s.linear);
    const std::size_t block = s.smooth[0].size() * s.smooth[1].size();
    Numbers at_block;
    for (std::size_t start = 0; start < s.value.size(); start += block) {
      const auto first = s.value.begin() + static_cast<std::ptrdiff_t>(start);
      const Numbers f(first, first + static_cast<std::ptrdiff_t>(block));
      at_block.push_back(nested_hermite(s.smooth[0], s.smooth[1], f, x[0], x[1]));
    }
    CHECK_NEAR(look(s, Interpolation::c1, x, p), multilinear(s.linear, at_block, p), 1e-13);
  }
}

TEST(table_reproduces_its_nodes) {
  Random random;
  const Sample<3, 1> s(random, {3, 4, 3, 5});
  for (const Interpolation mode : kModes) {
    std::size_t index = 0;
    for (const double p : s.linear[0])
      for (const double x : s.smooth[0])
        for (const double y : s.smooth[1])
          for (const double z : s.smooth[2])
            CHECK_NEAR(look(s, mode, Numbers{x, y, z}, Numbers{p}), s.value[index++], 1e-15);
  }
}

// One axis: between two nodes the curve stays between their values.
TEST(table_c1_does_not_overshoot) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    const Sample<1, 0> s(random, {8});
    for (std::size_t i = 0; i + 1 < s.value.size(); ++i) {
      const double low = std::min(s.value[i], s.value[i + 1]);
      const double high = std::max(s.value[i], s.value[i + 1]);
      for (int k = 0; k <= 50; ++k) {
        const double x = s.smooth[0][i] + (s.smooth[0][i + 1] - s.smooth[0][i]) * k / 50;
        const double f = look(s, Interpolation::c1, Numbers{x});
        CHECK(f >= low - 1e-14 && f <= high + 1e-14);
      }
    }
  }
}

// ---- ends ----

TEST(table_holds_its_end_values_with_zero_slope) {
  Random random;
  const Sample<2, 0> s(random, {4, 5});
  const Numbers& x = s.smooth[0];
  const Numbers& y = s.smooth[1];
  for (const Interpolation mode : kModes) {
    const double inside = 0.5 * (y[1] + y[2]);
    for (const double end : {x.front(), x.back()}) {
      const double outside = end == x.front() ? end - 1 : end + 1;
      const auto at_end = look(s, mode, dual_variables<2>({end, inside}));
      const auto beyond = look(s, mode, dual_variables<2>({outside, inside}));
      CHECK_EQ(beyond.v, at_end.v);
      CHECK_EQ(beyond.d.get(0), 0.0);
      CHECK_NEAR(beyond.d.get(1), at_end.d.get(1), 1e-14);
    }
    const auto corner = look(s, mode, dual_variables<2>({x.back() + 1, y.front() - 1}));
    CHECK_NEAR(corner.v, s.value[(x.size() - 1) * y.size()], 1e-15);
    CHECK_EQ(corner.d.get(0), 0.0);
    CHECK_EQ(corner.d.get(1), 0.0);
  }
}

TEST(table_end_node_counts_as_inside) {
  Random random;
  const Sample<1, 0> s(random, {5});
  const Numbers& x = s.smooth[0];
  const Numbers m = slopes(x, s.value);
  const auto first = look(s, Interpolation::c1, dual_variables<1>({x.front()}));
  const auto last = look(s, Interpolation::c1, dual_variables<1>({x.back()}));
  CHECK_NEAR(first.d.get(0), m.front(), 1e-13);
  CHECK_NEAR(last.d.get(0), m.back(), 1e-13);
  const std::size_t n = x.size();
  const double last_secant = (s.value[n - 1] - s.value[n - 2]) / (x[n - 1] - x[n - 2]);
  CHECK_NEAR(look(s, Interpolation::linear, dual_variables<1>({x.back()})).d.get(0), last_secant, 1e-13);
}

// An axis with one knot is a constant.
TEST(table_axis_with_one_knot_has_no_slope) {
  Random random;
  const Sample<2, 0> s(random, {4, 1});
  const double x = 0.5 * (s.smooth[0][1] + s.smooth[0][2]);
  for (const Interpolation mode : kModes) {
    const auto on = look(s, mode, dual_variables<2>({x, s.smooth[1][0]}));
    const auto off = look(s, mode, dual_variables<2>({x, 99.0}));
    CHECK_EQ(on.v, off.v);
    CHECK_EQ(on.d.get(1), 0.0);
    CHECK_EQ(off.d.get(1), 0.0);
    CHECK_EQ(on.d.get(0), off.d.get(0));
  }
}

TEST(table_finds_every_interval) {
  Random random;
  for (int count = 2; count <= tiltrotor::kMaxKnots; ++count) {
    const Numbers knots = uneven_knots(random, count);
    const Axis<double> axis{count, knots.data()};
    for (int i = 0; i < count; ++i) {
      const int expected = std::min(i, count - 2);
      CHECK_EQ(tiltrotor::find_interval(axis, knots[static_cast<std::size_t>(i)]), expected);
      CHECK_EQ(tiltrotor::find_interval(axis, knots[static_cast<std::size_t>(i)] + 0.1), expected);
    }
    CHECK_EQ(tiltrotor::find_interval(axis, knots[0] - 1), 0);
  }
}

// ---- slopes ----

TEST(table_slopes_of_straight_lines_and_extrema) {
  const Numbers x{0, 1, 3, 4};
  Numbers m(4);
  const Numbers line{1, 3, 7, 9};
  tiltrotor::monotone_slopes(4, x.data(), line.data(), m.data(), 1);
  for (const double slope : m) CHECK_NEAR(slope, 2.0, 1e-15);
  const Numbers hill{0, 2, 2, 0};
  tiltrotor::monotone_slopes(4, x.data(), hill.data(), m.data(), 1);
  CHECK_EQ(m[1], 0.0);
  CHECK_EQ(m[2], 0.0);
  // End after an extremum: at most three times the secant of the end interval.
  const Numbers spike{0, 1, -50, -51};
  tiltrotor::monotone_slopes(4, x.data(), spike.data(), m.data(), 1);
  CHECK_EQ(m[0], 3.0);
}

TEST(table_works_in_single_precision) {
  const float knots[] = {0.0F, 1.0F, 3.0F};
  float node[] = {1.0F, 0.0F, 2.0F, 0.0F, 5.0F, 0.0F};
  float scratch[6];
  const Axis<float> axis[1] = {{3, knots}};
  tiltrotor::fill_slopes<float, 1>(axis, node, scratch);
  const Table<float, 1> table{{{3, knots}}, {{0, nullptr}}, node};
  const double expected = hermite({0, 1, 3}, {1, 2, 5}, slopes({0, 1, 3}, {1, 2, 5}), 2.2);
  CHECK_NEAR(tiltrotor::lookup(table, Interpolation::c1, 2.2F), expected, 1e-6);
  const auto f = tiltrotor::lookup(table, Interpolation::c1, Dual<float, 1>::variable(2.2F, 0));
  CHECK_NEAR(f.v, expected, 1e-6);
}

// An axis with one knot has one value everywhere.
TEST(table_linear_axis_of_one_knot) {
  const double knot[] = {3};
  const Axis<double> axis{1, knot};
  for (double x : {-1e9, 2.9, 3.0, 3.1, 1e9}) {
    const GridPoint<double> p = grid_point(axis, x);
    CHECK(p.interval == 0 && p.fraction == 0);
  }
}
