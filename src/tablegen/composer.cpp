#include "tablegen/composer.hpp"

#include <algorithm>
#include <filesystem>

#include "tablegen/fault.hpp"
#include "tiltrotor/model/aircraft/aircraft.hpp"

namespace tablegen {

namespace {

// Lists for people, with words in their cells: read as CSV, not as a grid.
const char* const kLists[] = {"airfoil_stations.csv"};

}  // namespace

Composer::Composer(const std::string& folder, const Entries& entries)
    : folder_(folder), incompressible_mach_(entries.in("tail_incompressible_mach", "ND")) {
  for (const double angle : flap_settings(entries)) {
    flap_deg_.push_back(angle);
    flap_names_.push_back("FL" + std::to_string(flap_deg_.size()));
  }
  files_.read((std::filesystem::path(folder) / "tables.csv").string(), static_cast<int>(flap_deg_.size()));
}

void Composer::check_the_rest() {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  for (const char* const part : {"airframe", "rotor_airfoil"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder_) / part))
      if (entry.path().extension() == ".csv")
        names.push_back(std::string(part) + "/" + entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    const auto is_list = [&](const char* list) { return fs::path(name).filename() == list; };
    if (std::any_of(std::begin(kLists), std::end(kLists), is_list)) {
      read_csv((fs::path(folder_) / name).string());
    } else {
      grid(name.substr(0, name.size() - 4));
    }
  }
  files_.check_all_used();
}

const Grid& Composer::grid(const std::string& name) {
  const auto known = grids_.find(name);
  if (known != grids_.end()) return known->second;
  return grids_.emplace(name, read_grid((std::filesystem::path(folder_) / (name + ".csv")).string()))
      .first->second;
}

Curve Composer::curve(const std::string& name, const std::string& column, const std::string& unit,
                      const std::string& to) {
  return grid(name).column(column, unit, to);
}

Surface Composer::surface(const std::string& name, const std::string& prefix, double scale) {
  const Grid& g = grid(name);
  std::vector<double> y = g.labels(g.names(), prefix);
  for (double& label : y) label /= scale;
  std::vector<Curve> columns;
  for (const std::string& column : g.names()) columns.push_back(g.column(column, "ND", "ND"));
  return side_by_side(columns, y);
}

void Composer::check_same_columns(const std::string& name, const std::string& as) {
  if (grid(name).names() != grid(as).names())
    throw Fault{grid(name).csv.file, grid(name).csv.header_line,
                "columns differ from those of " + grid(as).csv.file};
}

void Composer::put(const std::string& field, const std::string& source, const Curve& c) {
  tables.push_back({field, source, {c.knot}, {}, c.value, c.half});
}

void Composer::put(const std::string& field, const std::string& source, const Surface& s) {
  put_stack(field, source, {}, std::vector<Surface>{s});
}

void Composer::put_stack(const std::string& field, const std::string& source,
                         std::vector<std::vector<double>> linear, const std::vector<Surface>& stack) {
  std::vector<double> x;
  for (const Surface& s : stack) x = union_of(x, s.x);
  TableArray table{field, source, {x, stack.front().y}, std::move(linear), {}, {}};
  for (const Surface& s : stack) {
    std::vector<Curve> columns;
    for (const Curve& column : s.column) columns.push_back(resampled(column, x));
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (const Curve& column : columns) {
        table.value.push_back(column.value[i]);
        table.half.push_back(column.half[i]);
      }
    }
  }
  tables.push_back(std::move(table));
}

void Composer::put_stack(const std::string& field, const std::string& source,
                         std::vector<std::vector<double>> linear, const std::vector<Curve>& stack) {
  std::vector<double> x;
  for (const Curve& c : stack) x = union_of(x, c.knot);
  TableArray table{field, source, {x}, std::move(linear), {}, {}};
  for (const Curve& c : stack) {
    const Curve on_x = resampled(c, x);
    table.value.insert(table.value.end(), on_x.value.begin(), on_x.value.end());
    table.half.insert(table.half.end(), on_x.half.begin(), on_x.half.end());
  }
  tables.push_back(std::move(table));
}

void Composer::put_single(const std::string& field, const std::string& column, const std::string& unit,
                          const std::string& to, const std::string& from) {
  const std::string name = files_.file(from.empty() ? field : from);
  put(field, name, curve(name, column, unit, to));
}

void Composer::put_odd(const std::string& field, const std::string& column, const std::string& unit,
                       const std::string& to) {
  const std::string name = files_.file(field);
  const Curve half = curve(name, column, unit, to);
  const Csv& csv = grid(name).csv;
  if (half.knot.front() != 0 || half.value.front() != 0)
    throw Fault{csv.file, csv.rows.front().line, "an odd function must begin with 0 at 0"};
  put(field, name + ", odd half written out", with_odd_half(half));
}

void Composer::put_by_flap(const std::string& field, const std::string& unit, const std::string& to) {
  const std::string name = files_.file(field);
  std::vector<Curve> stack;
  for (const std::string& flap : flap_names_) stack.push_back(curve(name, flap, unit, to));
  put_stack(field, name, {flap_deg_}, stack);
}

void Composer::put_mach(const std::string& field) {
  const std::string name = files_.file(field);
  put(field, name, from_mach_0(surface(name, "M", 100)));
}

}  // namespace tablegen
