#include "cli/linear_json.hpp"

#include "cli/errors.hpp"
#include "text/json.hpp"

namespace tiltrotor::cli {

namespace {

std::string bracketed(const std::string& text) { return "[" + text + "]"; }

std::string member(const char* name, const std::string& value) {
  return "\"" + std::string(name) + "\": " + value;
}

std::string named(const char* name, const char* unit) {
  return json_object({{"name", json_text(name)}, {"unit", json_text(unit)}});
}

}  // namespace

std::string joined(int count, const std::string& separator, const std::function<std::string(int)>& item) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i > 0 ? separator : "") + item(i);
  return text;
}

std::string matrix_text(int rows, int columns, const std::string& row_separator, const std::string& separator,
                        const std::function<double(int, int)>& entry,
                        const std::function<std::string(const std::string&)>& wrap) {
  return joined(rows, row_separator, [&](int i) {
    return wrap(joined(columns, separator, [&](int j) { return json_number(entry(i, j)); }));
  });
}

std::string settings_json(const LinearSettings& settings) {
  std::vector<JsonMember> members, switches;
  for (const LinearSettings::Number& n : settings.numbers) members.emplace_back(n.name, json_number(n.value));
  for (const auto& [name, value] : settings.words) members.emplace_back(name, json_text(value));
  const auto gain = [&](int k) {
    const FeedbackGain& g = settings.feedback[static_cast<std::size_t>(k)];
    return json_object(
        {{"input", json_text(g.input)}, {"output", json_text(g.output)}, {"gain", json_number(g.gain)}});
  };
  if (!settings.feedback.empty())
    members.emplace_back("feedback",
                         "[" + joined(static_cast<int>(settings.feedback.size()), ", ", gain) + "]");
  for (const auto& [name, value] : settings.switches) switches.emplace_back(name, json_text(value));
  members.emplace_back("switches", json_object(switches));
  return json_object(members);
}

std::string names_json(const ShownModel& model) {
  const auto names = [](const char* name, int count, const std::function<std::string(int)>& item) {
    return member(name, "[" + joined(count, ", ", item) + "]");
  };
  std::string text =
      names("states", model.states, [&](int i) { return named(model.state_name(i), model.state_unit(i)); }) +
      ",\n" + names("controls", model.controls, [&](int j) {
        return named(model.control_name(j), model.control_unit(j));
      });
  if (model.outputs > 0)
    text += ",\n" + names("outputs", model.outputs,
                          [&](int i) { return named(model.output_name(i), model.output_unit(i)); });
  return text;
}

std::string matrices_json(const ShownModel& model) {
  const int n = model.states, m = model.controls, k = model.outputs;
  const auto matrix = [](const char* name, int rows, int columns,
                         const std::function<double(int, int)>& entry) {
    return ",\n" + member(name, "[\n" + matrix_text(rows, columns, ",\n", ", ", entry, bracketed) + "\n]");
  };
  std::string text = member("x0", json_array(model.x)) + ",\n" + member("u0", json_array(model.u));
  if (k > 0) text += ",\n" + member("y0", json_array(model.y));
  text += matrix("A", n, n, [&](int i, int j) { return model.a(i, j); });
  text += matrix("B", n, m, [&](int i, int j) { return model.b(i, j); });
  if (k > 0) text += matrix("C", k, n, [&](int i, int j) { return model.c(i, j); });
  if (k > 0) text += matrix("D", k, m, [&](int i, int j) { return model.d(i, j); });
  return text;
}

}  // namespace tiltrotor::cli
