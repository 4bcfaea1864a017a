#include "cli/linear_output.hpp"

#include <functional>

#include "cli/errors.hpp"
#include "cli/linear_json.hpp"
#include "cli/output.hpp"
#include "cli/stamp.hpp"
#include "text/identity.hpp"
#include "text/json.hpp"
#include "text/number.hpp"

namespace tiltrotor::cli {

namespace {

using Model = ShownModel;

// In single quotes, which are doubled inside.
std::string matlab_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}
std::string unchanged(const std::string& text) { return text; }

// An array of structures, one for each gain.
std::string matlab_gains(const std::string& name, const std::vector<FeedbackGain>& gains) {
  if (gains.empty()) return "";
  const auto cells = [&](const std::function<std::string(const FeedbackGain&)>& text) {
    const int count = static_cast<int>(gains.size());
    return "{" + joined(count, ", ", [&](int k) { return text(gains[static_cast<std::size_t>(k)]); }) + "}";
  };
  return name + "settings.feedback = struct('input', " +
         cells([](const FeedbackGain& g) { return matlab_text(g.input); }) + ", 'output', " +
         cells([](const FeedbackGain& g) { return matlab_text(g.output); }) + ", 'gain', " +
         cells([](const FeedbackGain& g) { return number_text(g.gain); }) + ");\n";
}

// The system object of MATLAB and of Octave's control package, whose states are its outputs where the model has none; a
// word of the first case where that is not there.
std::string matlab_system(const std::string& name, bool has_outputs) {
  const std::string n = name;
  const std::string c = has_outputs ? n + "C, " + n + "D" : "eye(size(" + n + "A)), zeros(size(" + n + "B))";
  return "if exist('ss')\n  " + n + "ss = ss(" + n + "A, " + n + "B, " + c + ", 'StateName', " + n +
         "states, 'InputName', " + n + "controls, 'OutputName', " + n + (has_outputs ? "outputs" : "states") +
         ");\n" +
         (n == "model(1)."
              ? "else\n  disp('model(k).ss is left out: ss() is of the control package (Octave: pkg load control, and "
                "before once pkg install -forge control) or the Control System Toolbox.');\n"
              : "") +
         "end\n";
}

}  // namespace

OptionList LinearOutput::list() {
  return {
      {"--format", "KIND",
       "csv (one entry a line: x0, u0, A, B; with --outputs y0, C, D), json, matlab (a script) or\n"
       "table (table on a terminal, else csv)"},
      output_option(),
      units_option(),
      stamp_option(),
      shard_option(),
  };
}

LinearOutput::LinearOutput(const Arguments& arguments, bool single, const std::vector<std::string>& swept)
    : sink_(arguments.text("--output", "-"), arguments.where("--output")),
      shard_(parse_shard(arguments.text("--shard", "1/1"), arguments.where("--shard"))),
      kind_(static_cast<Kind>(
          arguments.choice("--format", sink_.is_terminal() && !arguments.given("--shard") ? "table" : "csv",
                           {"table", "csv", "json", "matlab"}))),
      single_(single),
      stamp_(stamp_of(arguments, arguments.text("--format", "csv"))),
      swept_(swept) {
  if (shard_.parts > 1 && kind_ != Kind::csv) {
    throw UsageError(arguments.where("--shard") + ": parts can be joined with --format csv only");
  }
  if (kind_ == Kind::csv && shard_.first()) {
    std::string header = "case,mast_deg,speed_mps,status,matrix,row,row_unit,column,column_unit,value";
    for (const std::string& name : swept_) header += "," + name;
    sink_.write(stamp_ + header + "\n");
  }
  if (kind_ == Kind::table) sink_.write(stamp_);
  if (kind_ == Kind::json && !single_) sink_.write("[\n");
}

void LinearOutput::add(const LinearCase& which, const Model& model) {
  if (kind_ == Kind::table) add_table(which, model);
  if (kind_ == Kind::csv) add_csv(which, model);
  if (kind_ == Kind::json) add_json(which, model);
  if (kind_ == Kind::matlab) add_matlab(which, model);
  ++count_;
}

void LinearOutput::finish() {
  if (kind_ == Kind::json) sink_.write(single_ ? "\n" : "\n]\n");
  sink_.finish();
}

void LinearOutput::add_csv(const LinearCase& which, const Model& model) {
  const std::string begin = csv_cell(which.name) + "," + number_text(which.mast_deg) + "," +
                            number_text(which.speed) + "," + which.status + ",";
  std::string end;
  for (const double value : which.swept) end += "," + number_text(value);
  if (!which.valid) {
    sink_.write(begin + ",,,,," + end + "\n");
    return;
  }
  std::string text;
  const auto line = [&](const char* matrix, const char* row, const char* row_unit, const char* column,
                        const char* column_unit, double value) {
    text += begin + matrix + "," + row + "," + row_unit + "," + column + "," + column_unit + "," +
            number_text(value) + end + "\n";
  };
  for (int i = 0; i < model.states; ++i)
    line("x0", model.state_name(i), model.state_unit(i), "", "", model.x[static_cast<std::size_t>(i)]);
  for (int j = 0; j < model.controls; ++j) {
    line("u0", model.control_name(j), model.control_unit(j), "", "", model.u[static_cast<std::size_t>(j)]);
  }
  for (int i = 0; i < model.states; ++i) {
    for (int j = 0; j < model.states; ++j) {
      line("A", model.state_name(i), model.state_unit(i), model.state_name(j), model.state_unit(j),
           model.a(i, j));
    }
  }
  for (int i = 0; i < model.states; ++i) {
    for (int j = 0; j < model.controls; ++j) {
      line("B", model.state_name(i), model.state_unit(i), model.control_name(j), model.control_unit(j),
           model.b(i, j));
    }
  }
  for (int i = 0; i < model.outputs; ++i)
    line("y0", model.output_name(i), model.output_unit(i), "", "", model.y[static_cast<std::size_t>(i)]);
  for (int i = 0; i < model.outputs; ++i) {
    for (int j = 0; j < model.states; ++j) {
      line("C", model.output_name(i), model.output_unit(i), model.state_name(j), model.state_unit(j),
           model.c(i, j));
    }
  }
  for (int i = 0; i < model.outputs; ++i) {
    for (int j = 0; j < model.controls; ++j) {
      line("D", model.output_name(i), model.output_unit(i), model.control_name(j), model.control_unit(j),
           model.d(i, j));
    }
  }
  sink_.write(text);
}

void LinearOutput::add_json(const LinearCase& which, const Model& model) {
  std::string text = count_ > 0 ? ",\n" : "";
  text += "{\n\"case\": " + json_text(which.name) + ",\n\"mast_deg\": " + json_number(which.mast_deg) +
          ",\n\"speed_mps\": " + json_number(which.speed) + ",\n\"status\": " + json_text(which.status) +
          ",\n\"program\": " + program_and_commit_json() +
          ",\n\"settings\": " + settings_json(which.settings);
  if (which.valid) text += ",\n" + names_json(model) + ",\n" + matrices_json(model);
  sink_.write(text + "\n}");
}

void LinearOutput::add_matlab(const LinearCase& which, const Model& model) {
  const std::string name = "model(" + std::to_string(count_ + 1) + ").";
  std::string text =
      (count_ > 0        ? ""
       : !stamp_.empty() ? stamp_
                         : "% " + identity_text() + "\n") +
      "% case " + which.name + ": mast " + number_text(which.mast_deg) + " deg, " + number_text(which.speed) +
      " m/s; xdot = A (x - x0) + B (u - u0)\n" + name + "case_name = " + matlab_text(which.name) + ";\n" +
      name + "mast_deg = " + number_text(which.mast_deg) + ";\n" + name +
      "speed_mps = " + number_text(which.speed) + ";\n" + name + "status = '" + which.status + "';\n";
  for (const LinearSettings::Number& s : which.settings.numbers)
    text += name + "settings." + s.name + " = " + number_text(s.value) + ";\n";
  for (const auto& [word, value] : which.settings.words)
    text += name + "settings." + word + " = " + matlab_text(value) + ";\n";
  text += matlab_gains(name, which.settings.feedback);
  for (const auto& [word, value] : which.settings.switches)
    text += name + "settings.switches." + word + " = " + matlab_text(value) + ";\n";
  if (which.valid) {
    const int n = model.states;
    const int m = model.controls;
    const auto words = [&](const char* member, int count, const std::function<const char*(int)>& word) {
      text += name + member + " = {" +
              joined(count, ", ", [&](int i) { return "'" + std::string(word(i)) + "'"; }) + "};\n";
    };
    const auto numbers = [&](const char* member, int rows, int columns,
                             const std::function<double(int, int)>& entry) {
      text += name + member + " = [\n" + matrix_text(rows, columns, ";\n", " ", entry, unchanged) + "];\n";
    };
    words("states", n, [&](int i) { return model.state_name(i); });
    words("state_units", n, [&](int i) { return model.state_unit(i); });
    words("controls", m, [&](int j) { return model.control_name(j); });
    words("control_units", m, [&](int j) { return model.control_unit(j); });
    const int k = model.outputs;
    if (k > 0) words("outputs", k, [&](int i) { return model.output_name(i); });
    if (k > 0) words("output_units", k, [&](int i) { return model.output_unit(i); });
    numbers("x0", n, 1, [&](int i, int) { return model.x[static_cast<std::size_t>(i)]; });
    numbers("u0", m, 1, [&](int j, int) { return model.u[static_cast<std::size_t>(j)]; });
    if (k > 0) numbers("y0", k, 1, [&](int i, int) { return model.y[static_cast<std::size_t>(i)]; });
    numbers("A", n, n, [&](int i, int j) { return model.a(i, j); });
    numbers("B", n, m, [&](int i, int j) { return model.b(i, j); });
    if (k > 0) numbers("C", k, n, [&](int i, int j) { return model.c(i, j); });
    if (k > 0) numbers("D", k, m, [&](int i, int j) { return model.d(i, j); });
    text += matlab_system(name, k > 0);
  }
  sink_.write(text);
}

void LinearOutput::add_table(const LinearCase& which, const Model& model) {
  constexpr int digits = 5;
  constexpr std::size_t width = 13;
  const auto cell = [](const std::string& text) {
    return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
  };
  std::string also;
  for (std::size_t k = 0; k < which.swept.size(); ++k)
    also += ", " + swept_[k] + " " + number_text(which.swept[k]);
  std::string text = (count_ > 0 ? "\n" : "") + std::string("case ") + which.name + ": mast " +
                     number_text(which.mast_deg) + " deg, " + number_text(which.speed) + " m/s" + also +
                     ": " + which.status + "\n";
  if (which.valid) {
    text += cell("state") + cell("unit") + cell("x0") + " |" +
            joined(model.states, "", [&](int j) { return cell(model.state_name(j)); }) + " |" +
            joined(model.controls, "", [&](int j) { return cell(model.control_name(j)); }) + "\n";
    for (int i = 0; i < model.states; ++i) {
      text +=
          cell(model.state_name(i)) + cell(model.state_unit(i)) +
          cell(number_text(model.x[static_cast<std::size_t>(i)], digits)) + " |" +
          joined(model.states, "", [&](int j) { return cell(number_text(model.a(i, j), digits)); }) + " |" +
          joined(model.controls, "", [&](int j) { return cell(number_text(model.b(i, j), digits)); }) + "\n";
    }
    for (int i = 0; i < model.outputs; ++i) {
      text +=
          cell(model.output_name(i)) + cell(model.output_unit(i)) +
          cell(number_text(model.y[static_cast<std::size_t>(i)], digits)) + " |" +
          joined(model.states, "", [&](int j) { return cell(number_text(model.c(i, j), digits)); }) + " |" +
          joined(model.controls, "", [&](int j) { return cell(number_text(model.d(i, j), digits)); }) + "\n";
    }
  }
  sink_.write(text);
}

}  // namespace tiltrotor::cli
