#include "tablegen/flat_knots.hpp"

#include <algorithm>
#include <limits>

#include "tablegen/compose.hpp"
#include "tiltrotor/math/tables/table.hpp"

namespace tablegen {

namespace {

// The lines of values along one smooth axis: value number `first + k * step` at knot k.
struct Lines {
  std::size_t knots, step;
  std::vector<std::size_t> first;

  Lines(const TableArray& table, std::size_t axis)
      : knots(table.smooth[axis].size()),
        step(axis + 1 == table.smooth.size() ? 1 : table.smooth.back().size()) {
    for (std::size_t n = 0; n < table.value.size(); ++n)
      if (n / step % knots == 0) first.push_back(n);
  }
};

std::vector<double> refined(const TableArray& table, std::size_t axis) {
  const std::vector<double>& knot = table.smooth[axis];
  const Lines lines(table, axis);
  std::vector<double> added;
  for (std::size_t i = 0; i + 1 < knot.size(); ++i) {
    const double length = knot[i + 1] - knot[i];
    const auto flat = [&](std::size_t line, std::size_t interval) {
      const std::size_t left = line + interval * lines.step;
      return table.value[left] == table.value[left + lines.step];
    };
    const auto grade = [&](double end, double towards, std::size_t beside) {
      const bool bends = std::any_of(lines.first.begin(), lines.first.end(),
                                     [&](std::size_t line) { return flat(line, i) && !flat(line, beside); });
      if (!bends) return;
      const double nearest = std::min(knot[beside + 1] - knot[beside], length) / 2;
      for (double d = nearest; d <= length / 2; d *= 2) added.push_back(end + towards * d);
    };
    if (i > 0) grade(knot[i], 1, i - 1);
    if (i + 2 < knot.size()) grade(knot[i + 1], -1, i + 1);
  }
  std::sort(added.begin(), added.end());
  added.erase(std::unique(added.begin(), added.end()), added.end());
  const std::vector<double> all = union_of(knot, added);
  return all.size() > tiltrotor::kMaxKnots ? knot : all;
}

TableArray on_knots(const TableArray& table, std::size_t axis, const std::vector<double>& knots) {
  TableArray result = table;
  result.smooth[axis] = knots;
  result.value.assign(table.value.size() / table.smooth[axis].size() * knots.size(), 0);
  result.half = result.value;
  const Lines from(table, axis);
  const Lines to(result, axis);
  for (std::size_t line = 0; line < from.first.size(); ++line) {
    Curve curve{table.smooth[axis], {}, {}};
    for (std::size_t k = 0; k < from.knots; ++k) {
      curve.value.push_back(table.value[from.first[line] + k * from.step]);
      curve.half.push_back(table.half[from.first[line] + k * from.step]);
    }
    for (std::size_t k = 0; k < to.knots; ++k) {
      const double x = knots[k];
      const std::size_t place = to.first[line] + k * to.step;
      result.value[place] = at(curve, x);
      result.half[place] = half_unit_at(curve, x);
      const auto right = std::lower_bound(curve.knot.begin(), curve.knot.end(), x);
      const auto r = static_cast<std::size_t>(right - curve.knot.begin());
      if (*right != x && curve.value[r - 1] == curve.value[r])
        result.half[place] = std::min(curve.half[r - 1], curve.half[r]);
    }
  }
  return result;
}

}  // namespace

TableArray with_flat_knots(const TableArray& table) {
  TableArray result = table;
  for (std::size_t axis = 0; axis < table.smooth.size(); ++axis)
    if (axis == 0 || !table.over_mach) result = on_knots(result, axis, refined(result, axis));
  return result;
}

}  // namespace tablegen
