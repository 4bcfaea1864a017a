// Writes the descriptions of the FMU: `describe model`, `describe page` and `describe build SOURCE...`, to standard output.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "fmu/fmi3.h"
#include "fmu/variables.hpp"

using namespace tiltrotor_fmu;

namespace {

std::string number(double value) {
  char text[40];
  for (int digits = 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::string escaped(const std::string& value) {
  std::string text;
  for (const char c : value)
    text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return text;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

// Units by the SI base units, and what they are shown in.
struct Unit {
  const char *name, *base, *display;
};
constexpr Unit kUnits[] = {
    {"m", "m=\"1\"", "name=\"ft\" factor=\"3.280839895013123\""},
    {"m/s", "m=\"1\" s=\"-1\"", "name=\"kt\" factor=\"1.9438444924406046\""},
    {"m/s2", "m=\"1\" s=\"-2\"", nullptr},
    {"rad", "rad=\"1\"", "name=\"deg\" factor=\"57.29577951308232\""},
    {"rad/s", "rad=\"1\" s=\"-1\"", "name=\"deg/s\" factor=\"57.29577951308232\""},
    {"s", "s=\"1\"", nullptr},
    {"kg", "kg=\"1\"", "name=\"lb\" factor=\"2.2046226218487757\""},
    {"K", "K=\"1\"", nullptr},
    {"N", "kg=\"1\" m=\"1\" s=\"-2\"", "name=\"lbf\" factor=\"0.22480894309971047\""},
    {"N.m", "kg=\"1\" m=\"2\" s=\"-2\"", nullptr},
    {"W", "kg=\"1\" m=\"2\" s=\"-3\"", "name=\"kW\" factor=\"0.001\""},
    {"in", "m=\"1\" factor=\"0.0254\"", nullptr},
    {"rad/s2", "rad=\"1\" s=\"-2\"", nullptr},
    {"W/s", "kg=\"1\" m=\"2\" s=\"-4\"", nullptr},
    {"kg/s", "kg=\"1\" s=\"-1\"", nullptr},
    {"1/s", "s=\"-1\"", nullptr},
};

const char* display_of(const std::string& unit) {
  return unit == "rad" ? "deg" : unit == "rad/s" ? "deg/s" : "";
}
std::string rate_unit(const std::string& unit) {
  if (unit.empty()) return "1/s";
  return unit.find("/s") != std::string::npos ? unit + "2" : unit + "/s";
}

const char* enumeration_of(int setting) {
  return setting == kGrid        ? "Grid"
         : setting == kTables    ? "Tables"
         : setting == kWindShear ? "WindShear"
                                 : "Governor";
}

bool is_rigid(int state) { return state <= TR_YAW || (state >= TR_NORTH && state <= TR_DOWN); }

std::string reference(const char* name, Role role, int index) {
  return attribute(name, std::to_string(reference_of(role, index)));
}

std::string with_unit(const std::string& unit, bool display = true) {
  std::string text;
  if (!unit.empty()) text += attribute("unit", unit);
  if (display && display_of(unit)[0] != 0) text += attribute("displayUnit", display_of(unit));
  return text;
}

std::string with_range(Place p) {
  const Range range = range_of(p);
  return attribute("min", number(range.low)) + attribute("max", number(range.high));
}

std::string shown_start(Place p, double start) {
  return type_of(p) == Type::boolean ? (start != 0 ? "true" : "false") : number(start);
}

void write_variable(Place p, double start) {
  const std::string unit = unit_of(p);
  std::string line;
  const auto opening = [&](const char* type, const char* causality, const char* variability) {
    line = std::string("    <") + type + attribute("name", full_name(p).text) +
           reference("valueReference", p.role, p.index) + attribute("causality", causality) +
           attribute("variability", variability);
  };
  switch (p.role) {
    case Role::time:
      opening("Float64", "independent", "continuous");
      line += attribute("unit", "s");
      break;
    case Role::state: {
      const bool begins = p.index < kContinuousStates;
      opening("Float64", is_rigid(p.index) ? "output" : "local", "continuous");
      line += attribute("initial", begins ? "exact" : "calculated") + with_unit(unit);
      if (begins)
        line += with_range(p) + attribute("start", number(start)) +
                attribute("nominal", number(nominal_of(unit_of(p))));
      if (p.index <= TR_W) line += attribute("reinit", "true");  // the wind jumps
      break;
    }
    case Role::rate:
      opening("Float64", "local", "continuous");
      line += attribute("initial", "calculated") + with_unit(rate_unit(unit), false) +
              reference("derivative", Role::state, p.index);
      break;
    case Role::input:
      opening("Float64", "input", "continuous");
      line += with_unit(unit) + with_range(p) + attribute("start", number(start));
      break;
    case Role::output:
      opening("Float64", "output", "continuous");
      line += attribute("initial", "calculated") + with_unit(unit);
      break;
    case Role::indicator:
      opening("Float64", "local", "continuous");
      line += attribute("initial", "calculated") + with_unit(unit);
      break;
    default: {
      const SettingFacts& facts = facts_of(p.index);
      const bool input = p.index >= kFirstInputSetting;
      const char* const type = facts.type == Type::float64   ? "Float64"
                               : facts.type == Type::boolean ? "Boolean"
                               : facts.type == Type::uint32  ? "UInt32"
                                                             : "Enumeration";
      opening(type, input ? "input" : "parameter", input ? "discrete" : "fixed");
      if (!input) line += attribute("initial", "exact");
      if (facts.type == Type::enumeration) line += attribute("declaredType", enumeration_of(p.index));
      line += with_unit(unit);
      if (facts.type == Type::float64) line += with_range(p);
      line += attribute("start", shown_start(p, start));
    }
  }
  if (text_of(p)[0] != 0) line += attribute("description", text_of(p));
  std::printf("%s/>\n", line.c_str());
}

// Dependencies, unless on everything.
void write_unknown(const char* element, Place unknown) {
  std::string dependencies;
  int count = 0;
  for (const Role role : {Role::state, Role::input})
    for (int k = 0; k < (role == Role::state ? kContinuousStates : static_cast<int>(TR_INPUTS)); ++k)
      if (depends(unknown, {role, k})) {
        dependencies += (count++ > 0 ? " " : "") + std::to_string(reference_of(role, k));
      }
  const bool all = count == kContinuousStates + TR_INPUTS;
  std::printf("    <%s%s%s/>\n", element, reference("valueReference", unknown.role, unknown.index).c_str(),
              all ? "" : attribute("dependencies", dependencies).c_str());
}

// An instance as it begins.
struct Begun {
  char token[64];
  fmi3Instance instance;

  Begun() {
    instantiation_token(token);
    instance = fmi3InstantiateModelExchange("describe", token, nullptr, false, false, nullptr, nullptr);
  }
  ~Begun() { fmi3FreeInstance(instance); }
  double start_of(Place p) const {
    const fmi3ValueReference at = reference_of(p.role, p.index);
    double value = 0;
    if (type_of(p) != Type::float64) return facts_of(p.index).start;
    return fmi3GetFloat64(instance, &at, 1, &value, 1) == fmi3OK ? value : std::nan("");
  }
};

int describe_model() {
  const Begun begun;
  if (begun.instance == nullptr) return 1;
  constexpr const char* kCapabilities =
      "modelIdentifier=\"tiltrotor\" canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" "
      "providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"";
  std::printf(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"3.0\" "
      "modelName=\"tiltrotor\"%s%s%s generationTool=\"tiltrotor\" variableNamingConvention=\"structured\">\n",
      attribute("instantiationToken", begun.token).c_str(), attribute("version", tr_version()).c_str(),
      attribute("description", tr_aircraft_description(tr_aircraft_at(0))).c_str());
  std::printf("  <ModelExchange %s/>\n  <CoSimulation %s canHandleVariableCommunicationStepSize=\"true\"/>\n",
              kCapabilities, kCapabilities);
  std::printf("  <UnitDefinitions>\n");
  for (const Unit& unit : kUnits)
    std::printf("    <Unit name=\"%s\"><BaseUnit %s/>%s%s%s</Unit>\n", unit.name, unit.base,
                unit.display != nullptr ? "<DisplayUnit " : "", unit.display != nullptr ? unit.display : "",
                unit.display != nullptr ? "/>" : "");
  std::printf(
      "  </UnitDefinitions>\n  <TypeDefinitions>\n"
      "    <EnumerationType name=\"Grid\"><Item name=\"realtime\" value=\"1\"/>"
      "<Item name=\"specification\" value=\"2\"/></EnumerationType>\n"
      "    <EnumerationType name=\"Tables\"><Item name=\"smooth\" value=\"1\"/>"
      "<Item name=\"linear\" value=\"2\"/></EnumerationType>\n"
      "    <EnumerationType name=\"Governor\"><Item name=\"off\" value=\"0\"/><Item name=\"ideal\" value=\"1\"/>"
      "<Item name=\"pi\" value=\"2\"/></EnumerationType>\n"
      "    <EnumerationType name=\"WindShear\"><Item name=\"none\" value=\"0\"/><Item name=\"terminal\" value=\"1\"/>"
      "<Item name=\"other\" value=\"2\"/></EnumerationType>\n"
      "  </TypeDefinitions>\n  <LogCategories>\n"
      "    <Category name=\"logEvents\"/>\n    <Category name=\"logStatusWarning\"/>\n"
      "    <Category name=\"logStatusDiscard\"/>\n    <Category name=\"logStatusError\"/>\n"
      "  </LogCategories>\n  <DefaultExperiment startTime=\"0\" stopTime=\"3\" stepSize=\"0.005\"/>\n"
      "  <ModelVariables>\n");
  for (int role = 0; role < static_cast<int>(Role::none); ++role)
    for (int k = 0; k < kCount[role]; ++k) {
      const Place p = {static_cast<Role>(role), k};
      write_variable(p, begun.start_of(p));
    }
  std::printf("  </ModelVariables>\n  <ModelStructure>\n");
  for (int k = 0; k < kContinuousStates; ++k)
    if (is_rigid(k)) write_unknown("Output", {Role::state, k});
  for (int k = 0; k < kOutputs; ++k) write_unknown("Output", {Role::output, k});
  for (int k = 0; k < kContinuousStates; ++k) write_unknown("ContinuousStateDerivative", {Role::rate, k});
  for (int k = 0; k < kOutputs; ++k)
    std::printf("    <InitialUnknown%s/>\n", reference("valueReference", Role::output, k).c_str());
  for (int k = 0; k < kContinuousStates; ++k)
    std::printf("    <InitialUnknown%s/>\n", reference("valueReference", Role::rate, k).c_str());
  for (int k = 0; k < kWheels; ++k) write_unknown("EventIndicator", {Role::indicator, k});
  std::printf("  </ModelStructure>\n</fmiModelDescription>\n");
  return 0;
}

// A row of the page: name, unit, range and start where it is set, what it is.
void write_row(Place p, double start) {
  const Range range = range_of(p);
  const bool is_set = range.high < HUGE_VAL;
  std::printf("<tr><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td></tr>\n", full_name(p).text,
              unit_of(p), is_set ? (number(range.low) + " .. " + number(range.high)).c_str() : "",
              is_set ? shown_start(p, start).c_str() : "", escaped(text_of(p)).c_str());
}

int describe_page() {
  const Begun begun;
  if (begun.instance == nullptr) return 1;
  std::printf(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>tiltrotor</title>\n"
      "<style>body { font-family: sans-serif } td, th { text-align: left; padding-right: 1em }</style></head>\n"
      "<body>\n<h1>tiltrotor %s</h1>\n<p>%s</p>\n<p>How a flight begins, what flies in Model Exchange and what in "
      "Co-Simulation: <a href=\"README.md\">README.md</a>. Licence: "
      "<a href=\"licenses/license.txt\">licenses/license.txt</a>.</p>\n",
      tr_version(), escaped(tr_aircraft_description(tr_aircraft_at(0))).c_str());
  const auto table = [&begun](const char* title, Role role, int first, int end) {
    std::printf(
        "<h2>%s</h2>\n<table>\n<tr><th>name</th><th>unit</th><th>range</th><th>start</th><th></th></tr>\n",
        title);
    for (int k = first; k < end; ++k) write_row({role, k}, begun.start_of({role, k}));
    std::printf("</table>\n");
  };
  table("Parameters", Role::setting, 0, kFirstInputSetting);
  table("Inputs", Role::input, 0, TR_INPUTS);
  table("Inputs that jump", Role::setting, kFirstInputSetting, kSettings);
  table("Outputs", Role::output, 0, kOutputs);
  table("Event indicators", Role::indicator, 0, kWheels);
  table("Continuous states", Role::state, 0, kContinuousStates);
  std::printf("</body>\n</html>\n");
  return 0;
}

int describe_build(int count, char** sources) {
  std::printf(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n"
      "  <BuildConfiguration modelIdentifier=\"tiltrotor\">\n    <SourceFileSet language=\"C++17\" "
      "compiler=\"gcc\" compilerOptions=\"-ffp-contract=off\">\n");
  for (int k = 0; k < count; ++k)
    std::printf("      <SourceFile%s/>\n", attribute("name", sources[k]).c_str());
  std::printf("      <PreprocessorDefinition name=\"TILTROTOR_VERSION\"%s/>\n",
              attribute("value", std::string("\"") + tr_version() + "\"").c_str());
  std::puts("      <IncludeDirectory name=\".\"/>");
  std::printf("    </SourceFileSet>\n  </BuildConfiguration>\n</fmiBuildDescription>\n");
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "model") == 0) return describe_model();
  if (count == 2 && std::strcmp(arguments[1], "page") == 0) return describe_page();
  if (count > 2 && std::strcmp(arguments[1], "build") == 0) return describe_build(count - 2, arguments + 2);
  std::fprintf(stderr, "describe model | describe page | describe build SOURCE...\n");
  return 2;
}
