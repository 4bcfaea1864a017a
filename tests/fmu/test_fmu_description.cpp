// What the description tells a person, and its ranges. Expected: what the unit accepts and refuses; the words on the page.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <cmath>

#include "fmu/master.hpp"
#include "plot/xml_check.hpp"

using namespace fmu;
using namespace tiltrotor_fmu;

namespace {

// Each variable's line.
template <class Each>
void each_variable(Each&& each) {
  const std::string text = description();
  const std::size_t begin = text.find("<ModelVariables>"), end = text.find("</ModelVariables>");
  for (std::size_t at = text.find("    <", begin); at < end; at = text.find("    <", at + 5))
    each(text.substr(at, text.find("/>", at) - at));
}

bool begins(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

}  // namespace

TEST(fmu_description_says_what_each_variable_is) {
  int count = 0;
  each_variable([&count](const std::string& line) {
    const std::string name = attribute(line, "name");
    if (name == "time" || begins(name, "der(")) return;
    ++count;
    if (!CHECK_LE(3u, attribute(line, "description").size())) NOTE(line);
  });
  CHECK_EQ(count, TR_STATES + TR_INPUTS + kOutputs + kSettings + kWheels);
}

// Both ends of a range are accepted, and what lies beyond either is refused.
TEST(fmu_description_has_the_ranges_that_are_accepted) {
  int inputs = 0, parameters = 0, states = 0;
  each_variable([&](const std::string& line) {
    const std::string name = attribute(line, "name"), low = attribute(line, "min"),
                      high = attribute(line, "max");
    const bool is_input = begins(name, "input."), is_parameter = begins(name, "parameter.");
    const bool begins_with = begins(name, "state.") && !attribute(line, "start").empty();
    if (!begins(line, "    <Float64") || !(is_input || is_parameter || begins_with)) return;
    (is_input ? inputs : is_parameter ? parameters : states) += 1;
    if (!CHECK(!low.empty() && !high.empty())) {
      NOTE(line);
      return;
    }
    const Reference at = static_cast<Reference>(std::stoul(attribute(line, "valueReference")));
    const double least = std::stod(low), most = std::stod(high), start = std::stod(attribute(line, "start"));
    CHECK(least <= start && start <= most);
    CHECK_LT(most, 1e10);
    for (const double end : {least, most}) {
      Master m(Master::co_simulation);
      if (is_input) CHECK_EQ(m.start(0, 40), fmi3OK);
      const double beyond = (end == least ? -1e-3 : 1e-3) * (most - least);
      if (!CHECK_EQ(m.set(at, end + beyond), fmi3Error)) NOTE(line);
      if (!CHECK_LE(m.set(at, end), fmi3Warning)) NOTE(line);
      if (is_input) CHECK_EQ(m.get(at), end);
    }
  });
  CHECK_EQ(inputs, TR_INPUTS + 5);
  CHECK_EQ(parameters, 15);
  CHECK_EQ(states, kContinuousStates);
}

TEST(fmu_page_names_every_variable_that_is_set_or_read) {
  std::ifstream in(std::string(TILTROTOR_BINARY_DIR) + "/fmu/index.html", std::ios::binary);
  const std::string page = {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  CHECK_EQ(check::XmlChecker::fault(page.substr(page.find("<html"))), "");
  each_variable([&page](const std::string& line) {
    const std::string name = attribute(line, "name");
    const bool begun = begins(name, "state.") && attribute(line, "start").empty();
    if (name == "time" || begins(name, "der(") || begun) return;
    if (!CHECK(page.find("<td>" + name + "</td>") != std::string::npos)) NOTE(name);
  });
}
#endif
