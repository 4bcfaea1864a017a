#include "tablegen/emit.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

#include "tablegen/aircraft_fields.hpp"
#include "tablegen/compose.hpp"
#include "tablegen/fault.hpp"
#include "tiltrotor/math/tables/table_slopes.hpp"

namespace tablegen {

namespace {

constexpr std::size_t kLineLength = 110;

// Fewest digits, at most 17, that read back as the same double; always with a point or an exponent.
std::string literal(double value) {
  char text[40];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value == 0 ? 0.0 : value);
    if (std::strtod(text, nullptr) == value) break;
  }
  std::string result = text;
  if (result.find_first_of(".e") == std::string::npos) result += ".0";
  return "R(" + result + ")";
}

// wing.lift_90[0] -> wing_lift_90_0
std::string array_name(const std::string& field) {
  std::string name;
  for (const char c : field) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += c;
    } else if (c != ']') {
      name += '_';
    }
  }
  return name;
}

// The nearest float, in digits that read back as it.
std::string single(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(static_cast<float>(value)));
  std::string result = text;
  if (result.find_first_of(".e") == std::string::npos) result += ".0";
  return result + "F";
}

void emit_array(std::ostream& out, const std::string& name, const std::vector<double>& values,
                const char* type = "R", std::string (*written)(double) = literal) {
  out << "  static constexpr " << type << " " << name << "[] = {\n";
  std::string line = "     ";
  for (const double value : values) {
    const std::string text = " " + written(value) + ",";
    if (line.size() + text.size() > kLineLength) {
      out << line << "\n";
      line = "     ";
    }
    line += text;
  }
  out << line << "\n  };\n";
}

// Values and slopes of every block of smooth axes: the nodes of one table.
template <int Smooth>
std::vector<double> nodes(const TableArray& table) {
  if (!table.fitted.empty()) return table.fitted;
  constexpr std::size_t per_node = std::size_t{1} << Smooth;
  tiltrotor::Axis<double> axis[Smooth];
  std::size_t block = per_node;
  for (std::size_t a = 0; a < Smooth; ++a) {
    axis[a] = {static_cast<int>(table.smooth[a].size()), table.smooth[a].data()};
    block *= table.smooth[a].size();
  }
  std::vector<double> node(table.value.size() * per_node);
  std::vector<double> scratch(block);
  for (std::size_t i = 0; i < table.value.size(); ++i) node[i * per_node] = table.value[i];
  const std::size_t row = block / table.smooth[0].size();  // from one knot of the first axis to the next
  for (std::size_t at = 0; at < node.size(); at += block) {
    const auto first = node.begin() + static_cast<std::ptrdiff_t>(at);
    const bool closed =
        around_circle(table.smooth[0]) && std::equal(first, first + static_cast<std::ptrdiff_t>(row),
                                                     first + static_cast<std::ptrdiff_t>(block - row));
    tiltrotor::fill_slopes<double, Smooth>(axis, &node[at], scratch.data(), closed);
  }
  return node;
}

// Index of an axis: the interval of each of some equal buckets, of which every knot begins one, and of the right end.
struct AxisIndex {
  std::vector<int> bucket;  // empty when the axis has none
  double per_width = 0;
};

constexpr std::size_t kMostBuckets = 256;
constexpr double kOffGrid = 1e-6;  // of a bucket: more is no rounding of a decimal number

// Number of buckets before each knot, or nothing when knots lie between them.
std::vector<double> places_of(const std::vector<double>& knot, std::size_t buckets) {
  std::vector<double> place;
  for (const double x : knot) {
    const double at = (x - knot.front()) * static_cast<double>(buckets) / (knot.back() - knot.front());
    if (std::abs(at - std::round(at)) > kOffGrid) return {};
    place.push_back(std::round(at));
  }
  return place;
}

// Whether the search of bracket.hpp finds every knot in its own bucket, in the arithmetic of R.
template <class R>
bool finds_knots(const std::vector<double>& knot, const std::vector<double>& place, double per_width) {
  for (std::size_t i = 0; i < knot.size(); ++i) {
    const volatile R from_first = static_cast<R>(knot[i]) - static_cast<R>(knot.front());
    const volatile R at = from_first * static_cast<R>(per_width);
    if (std::floor(at) != static_cast<R>(place[i])) return false;
  }
  return true;
}

AxisIndex index_of(const std::vector<double>& knot) {
  if (knot.size() < 3) return {};
  for (std::size_t buckets = knot.size() - 1; buckets < kMostBuckets; ++buckets) {
    const std::vector<double> place = places_of(knot, buckets);
    if (place.empty()) continue;
    double per_width = static_cast<double>(buckets) / (knot.back() - knot.front());
    constexpr int most_nudges = 3;  // the next numbers above, where rounding leaves a knot below its bucket
    for (int nudge = 0; nudge <= most_nudges; ++nudge, per_width = std::nextafter(per_width, 2 * per_width)) {
      if (!finds_knots<double>(knot, place, per_width) || !finds_knots<float>(knot, place, per_width))
        continue;
      AxisIndex index{{}, per_width};
      int interval = 0;
      for (std::size_t b = 0; b <= buckets; ++b) {
        const auto next = static_cast<std::size_t>(interval) + 1;
        if (next + 1 < knot.size() && static_cast<double>(b) >= place[next]) ++interval;
        index.bucket.push_back(interval);
      }
      return index;
    }
  }
  return {};
}

void emit_index(std::ostream& out, const std::string& name, const std::vector<int>& bucket) {
  if (bucket.empty()) return;
  out << "  static constexpr unsigned char " << name << "_bucket[] = {";
  for (std::size_t i = 0; i < bucket.size(); ++i) out << (i % 32 == 0 ? "\n      " : " ") << bucket[i] << ",";
  out << "\n  };\n";
}

std::string axis_name(const TableArray& table, const char* kind, std::size_t index) {
  return array_name(table.field) + "_" + kind + std::to_string(index);
}

// Smooth axes written so far: tables over equal knots share one array, by which a look-up knows that they do.
using AxisNames = std::map<std::vector<double>, std::string>;

// Whether the slopes stand in an array of their own: AirframeTable of airframe_tables.hpp.
bool is_split(const TableArray& table, Slopes slopes) {
  return slopes == Slopes::single && table.smooth.size() == 2 && table.field.compare(0, 6, "rotor.") != 0;
}

void emit_split_nodes(std::ostream& out, const TableArray& table) {
  constexpr std::size_t per_node = 4;
  const std::vector<double> node = nodes<2>(table);
  std::vector<double> value;
  std::vector<double> slope;
  for (std::size_t i = 0; i < node.size(); ++i) (i % per_node == 0 ? value : slope).push_back(node[i]);
  emit_array(out, array_name(table.field) + "_value", value);
  emit_array(out, array_name(table.field) + "_slope", slope, "typename StoredSlope<R>::type", single);
}

void emit_table_arrays(std::ostream& out, const TableArray& table, Slopes slopes, AxisNames& names) {
  out << "  // " << table.source << "\n";
  for (std::size_t a = 0; a < table.smooth.size(); ++a) {
    const auto [axis, is_new] = names.emplace(table.smooth[a], axis_name(table, "x", a));
    if (!is_new) continue;
    emit_array(out, axis->second, table.smooth[a]);
    emit_index(out, axis->second, index_of(table.smooth[a]).bucket);
  }
  for (std::size_t a = 0; a < table.linear.size(); ++a)
    emit_array(out, axis_name(table, "p", a), table.linear[a]);
  if (is_split(table, slopes)) return emit_split_nodes(out, table);
  emit_array(out, array_name(table.field) + "_node",
             table.smooth.size() == 1 ? nodes<1>(table) : nodes<2>(table));
}

void emit_table(std::ostream& out, const TableArray& table, Slopes slopes, const AxisNames& names) {
  out << "  // " << table.source << "\n";
  const auto axis = [&](const char* member, const char* kind, const std::vector<std::vector<double>>& axes) {
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const bool smooth = kind[0] == 'x';
      const AxisIndex index = smooth ? index_of(axes[a]) : AxisIndex{};
      const std::string name = smooth ? names.at(axes[a]) : axis_name(table, kind, a);
      out << "  a." << table.field << "." << member << "[" << a << "] = {" << axes[a].size()
          << ", A::" << name;
      if (index.bucket.empty()) {
        out << ", nullptr, R(0)";
      } else {
        out << ", A::" << name << "_bucket, " << literal(index.per_width);
      }
      out << ", " << (smooth ? literal(table.end_width[a]) : "R(0)") << "};\n";
    }
  };
  axis("smooth", "x", table.smooth);
  axis("linear", "p", table.linear);
  const std::string array = "A::" + array_name(table.field);
  out << "  a." << table.field << ".node = "
      << (is_split(table, slopes) ? "{" + array + "_value, " + array + "_slope}" : array + "_node") << ";\n";
}

// How far print rounded each value of a fitted table, for who asks what that changes.
void emit_print(std::ostream& out, const std::vector<TableArray>& tables) {
  for (const TableArray& table : tables) {
    if (table.fitted.empty()) continue;
    std::vector<double> half = table.half;
    for (double& width : half)
      if (!std::isfinite(width)) width = 0;
    emit_array(out, array_name(table.field) + "_half", half);
  }
}

void emit_print_visit(std::ostream& out, const std::vector<TableArray>& tables) {
  out << "// visit(name, table, half unit of the last printed digit of each value: 0 where none is printed) for every "
         "fitted\n// table of an aircraft.\n"
         "template <class R, class Visit>\nvoid visit_print(Aircraft<R>& a, Visit&& visit) {\n"
         "  using A = AircraftArrays<R>;\n";
  for (const TableArray& table : tables)
    if (!table.fitted.empty())
      out << "  visit(\"" << table.field << "\", a." << table.field << ", A::" << array_name(table.field)
          << "_half);\n";
  out << "}\n\n";
}

void emit_field(std::ostream& out, const Entries& entries, const Field& field) {
  const Entry& entry = entries[field.entry];
  const double value = entries.in(field.entry, field.unit);
  const bool whole = std::string(field.unit) == "count";
  out << "  a." << field.field << " = " << (whole ? std::to_string(std::lround(value)) : literal(value))
      << ";  // " << field.entry << " " << entry.text << " " << entry.unit << "\n";
}

// Numbers that no single entry gives.
void emit_derived(std::ostream& out, const Entries& entries) {
  const double aileron_limit =
      (entries.in("flaperon_roll_up_limit", "rad") + entries.in("flaperon_roll_down_limit", "rad")) / 2;
  out << "  a.controls.aileron_limit = " << literal(aileron_limit)
      << ";  // mean of flaperon_roll_up_limit and flaperon_roll_down_limit\n"
         "  a.htail.surface.bl = R(0);  // in the plane of symmetry\n"
         "  a.mass.design_0.xz = a.mass.inertia.xz;  // the design estimate has none: Ixz_0, and its value "
         "at mast 90\n"
         "  a.mass.design_90.xz = a.mass.inertia.xz + R(90) * a.mass.inertia_slope.xz;\n";
  const std::vector<double> flaps = flap_settings(entries);
  for (std::size_t i = 0; i < flaps.size(); ++i)
    out << "  a.wing.flap_deg[" << i << "] = " << literal(flaps[i]) << ";  // flap_setting_" << i + 1 << "\n";
  out << "  a.wing.flap_settings = " << flaps.size() << ";\n"
      << "  a.limits.flap_deg = {" << literal(flaps.front()) << ", " << literal(flaps.back()) << "};\n";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

bool is_fitted(const std::vector<TableArray>& tables) {
  return std::any_of(tables.begin(), tables.end(), [](const TableArray& t) { return !t.fitted.empty(); });
}

// Both sets of tables of an aircraft may stand in one program.
std::string space_of(const Identity& aircraft, const std::vector<TableArray>& tables) {
  return (is_fitted(tables) ? "c2_tables_of_" : "tables_of_") + array_name(aircraft.folder);
}

void emit_aircraft(std::ostream& out, const Identity& aircraft, const Entries& entries,
                   const std::vector<TableArray>& tables, Slopes slopes) {
  const bool fitted = is_fitted(tables);
  out << "// Generated by tablegen from tables/" << aircraft.folder
      << ": do not edit, change the CSV files.\n"
         "// Per table: _x smooth axes (those not written before), _p linear axes, _node values and slopes "
      << (fitted ? "of the C2 fit,\n// _half half units of the last printed digit.\n\n"
                 : "of the C1 interpolant.\n\n")
      << "#include \"tiltrotor/model/aircraft/aircraft.hpp\"\n\n"
         "namespace tiltrotor {\n\nnamespace "
      << space_of(aircraft, tables)
      << " {\n\n"
         "template <class R>\nstruct AircraftArrays {\n";
  AxisNames names;
  for (const TableArray& table : tables) emit_table_arrays(out, table, slopes, names);
  if (fitted) emit_print(out, tables);
  out << "};\n\n"
         "template <class R>\nconstexpr Aircraft<R> make_aircraft() {\n"
         "  using A = AircraftArrays<R>;\n"
         "  Aircraft<R> a{};\n";
  std::string group;
  for (const Field& field : kFields) {
    const std::string name = field.field;
    const std::string its_group = name.substr(0, name.find('.'));
    if (its_group != group) out << "\n";
    group = its_group;
    emit_field(out, entries, field);
  }
  out << "\n";
  emit_derived(out, entries);
  out << "\n";
  for (const TableArray& table : tables) emit_table(out, table, slopes, names);
  out << "  return a;\n}\n\n";
  if (fitted) emit_print_visit(out, tables);
  out << "inline constexpr AircraftIdentity kAircraftIdentity = {" << quoted(aircraft.folder) << ", "
      << quoted(aircraft.name) << ", " << quoted(aircraft.description) << ", " << aircraft.id << "};\n";
}

// FNV-1a.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

}  // namespace

void emit(std::ostream& out, const Identity& aircraft, const Entries& entries,
          const std::vector<TableArray>& tables, Slopes slopes) {
  std::ostringstream text;
  emit_aircraft(text, aircraft, entries, tables, slopes);
  out << text.str() << "// Of all numbers above.\ninline constexpr unsigned long long kAircraftFingerprint = "
      << hash_of(text.str()) << "u;\n\n}\n\nnamespace "
      << (is_fitted(tables) ? "c2_tables = " : "aircraft_tables = ") << space_of(aircraft, tables)
      << ";\n\n}  // namespace tiltrotor\n";
}

}  // namespace tablegen
