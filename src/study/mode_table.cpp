#include "study/mode_table.hpp"

#include <algorithm>
#include <cmath>

#include "plot/plot.hpp"
#include "study/missing.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

// A mode keeps its colour in every figure.
constexpr struct {
  const char* mode;
  const char* color;
  Marker marker;
} kModeStyle[] = {
    {"phugoid", kBlue, Marker::circle},
    {"aperiodic_phugoid", kBlue, Marker::circle},
    {"short_period", kOrange, Marker::square},
    {"heave", kGreen, Marker::triangle},
    {"pitch_subsidence", kPurple, Marker::diamond},
    {"dutch_roll", kBlue, Marker::circle},
    {"aperiodic_dutch_roll", kBlue, Marker::circle},
    {"roll", kOrange, Marker::square},
    {"spiral", kGreen, Marker::triangle},
    {"roll_spiral", kPurple, Marker::diamond},
};

bool has_ordinal(const std::string& mode) { return mode.find_last_of("23") + 1 == mode.size(); }  // "_2"

void set_style(std::string mode, Series& s) {
  if (has_ordinal(mode)) mode.resize(mode.size() - 2);
  s.color = kBlack;
  s.marker = Marker::plus;
  for (const auto& style : kModeStyle) {
    if (mode == style.mode) {
      s.color = style.color;
      s.marker = style.marker;
      return;
    }
  }
}

bool is_multiple(double value, double step) {
  return std::fabs(value / step - std::round(value / step)) < 1e-6;
}

// From root to root along every branch, where it arrives at a root of this name.
void trace(const Table& rows, const std::string& mode, Series& line) {
  const auto add = [&line](double x, double y) {
    line.x.push_back(x);
    line.y.push_back(y);
  };
  for (const std::string& number : rows.different("branch")) {
    const Table branch = rows.where("branch", number);
    for (std::size_t i = 1; i < branch.rows(); ++i) {
      if (branch.text(i, "mode") != mode) continue;
      if (i == 1 || branch.text(i - 1, "mode") != mode) {
        add(kMissing, kMissing);
        add(branch.number(i - 1, "real"), branch.number(i - 1, "imag"));
      }
      add(branch.number(i, "real"), branch.number(i, "imag"));
    }
  }
}

// Words for a name: "short_period" reads "short period".
std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

Table mode_table(std::vector<std::string> leading_columns) {
  for (const char* column :
       {"axis", "mode", "real", "imag", "frequency_rad_s", "damping_ratio", "time_to_half_s", "branch"}) {
    leading_columns.emplace_back(column);
  }
  Table table(std::move(leading_columns));
  table.comment(
      "Eigenvalues real +- imag i in 1/s of the complete linear model; modes of the airframe alone.");
  return table;
}

void add_modes(Table& table, const std::vector<double>& leading, const Modes& modes) {
  for (int k = 0; k < modes.count; ++k) {
    const Mode<double>& m = modes.mode[k];
    if (!is_body_mode(m)) continue;
    std::vector<Table::Cell> row(leading.begin(), leading.end());
    row.insert(row.end(), {std::string(axis_word(m.axis)), std::string(m.name), m.real, m.imag, m.frequency,
                           m.damping_ratio, m.time_to_half, static_cast<double>(m.branch)});
    table.add(row);
  }
}

PlaneWindow window_around(const Table& rows, const std::string& word, double left) {
  constexpr double margin = 0.08;  // on every side
  PlaneWindow w{0, 0, 0};
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const double real = rows.number(i, "real");
    if (real < left || rows.text(i, "mode").find(word) == std::string::npos) continue;
    w.left = std::min(w.left, real);
    w.right = std::max(w.right, real);
    w.top = std::max(w.top, rows.number(i, "imag"));
  }
  // At least as wide as high.
  const double wide = std::max({w.right - w.left, w.top, 0.1});
  const double side = margin * wide + 0.5 * (wide - (w.right - w.left));
  return {w.left - side, w.right + side, w.top + margin * wide};
}

Picture mode_picture(const ModePlot& what, const Table& rows) {
  Plot plot;
  plot.id = what.id;
  plot.title = what.title;
  plot.note = what.note;
  plot.x.label = "Real part, 1/s";
  plot.y.label = "Imaginary part, rad/s";
  plot.x.zero_line = true;
  plot.equal_scale = true;
  plot.x.low = what.window.left;
  plot.x.high = what.window.right;
  plot.y.low = 0;
  plot.y.high = what.window.top;
  const double wide = plot.x.high - plot.x.low;

  std::vector<Label> placed;
  for (const std::string& mode : rows.different("mode")) {
    const Table branch = rows.where("mode", mode);
    Series line;
    set_style(mode, line);
    Series marks = line;
    if (!has_ordinal(mode)) line.name = spaced(mode);
    line.marker = Marker::none;
    marks.line = Line::none;
    trace(rows, mode, line);
    const std::vector<double> parameter = branch.numbers(what.parameter);
    for (std::size_t i = 0; i < branch.rows(); ++i) {
      const bool end = i == 0 || i + 1 == branch.rows();
      if (!end && !is_multiple(parameter[i], what.label_step)) continue;
      const double x = branch.number(i, "real");
      const double y = branch.number(i, "imag");
      const std::string value = fixed(parameter[i], 0);
      marks.x.push_back(x);
      marks.y.push_back(y);
      marks.tip.push_back(spaced(mode) + ", " + value + " " + what.unit + ": " + root_text(x, y));
      const bool inside = x >= plot.x.low && x <= plot.x.high && y <= plot.y.high;
      const bool free = inside && std::none_of(placed.begin(), placed.end(), [&](const Label& l) {
                          return std::fabs(l.x - x) < 0.07 * wide && std::fabs(l.y - y) < 0.04 * wide;
                        });
      if (free) placed.push_back({x, y, value, line.color});
    }
    plot.series.push_back(line);
    plot.series.push_back(marks);
  }
  plot.labels = placed;
  return {what.id, svg(plot)};
}

}  // namespace tiltrotor::study
