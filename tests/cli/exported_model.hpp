// A linear model as `linearize --format json` writes it, for tests that compute with it.
#pragma once

#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace check {

struct ExportedModel {
  std::vector<std::string> states, controls, outputs;
  std::vector<double> x0, u0, y0, a, b, c, d;  // matrices by rows

  explicit ExportedModel(const std::string& arguments) {
    const ProgramResult run = run_tiltrotor("linearize --format json " + arguments);
    if (run.exit_status != 0) throw std::runtime_error("linearize " + arguments + ": " + run.err);
    const std::string& json = run.out;
    states = names(json, "states");
    controls = names(json, "controls");
    outputs = names(json, "outputs");
    x0 = numbers(json, "x0");
    u0 = numbers(json, "u0");
    y0 = numbers(json, "y0");
    a = numbers(json, "A");
    b = numbers(json, "B");
    c = numbers(json, "C");
    d = numbers(json, "D");
  }
  std::size_t n() const { return states.size(); }
  std::size_t m() const { return controls.size(); }
  static std::size_t place(const std::vector<std::string>& names, const std::string& name) {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k] == name) return k;
    throw std::runtime_error("no " + name);
  }

 private:
  // Text of a member that is an array, without its brackets; empty where there is none.
  static std::string member(const std::string& json, const std::string& name) {
    const std::string key = "\n\"" + name + "\": [";
    const std::size_t begin = json.find(key);
    if (begin == std::string::npos) return "";
    std::size_t end = begin + key.size();
    for (int open = 1; open > 0; ++end) open += json.at(end) == '[' ? 1 : json[end] == ']' ? -1 : 0;
    return json.substr(begin + key.size(), end - 1 - begin - key.size());
  }
  static std::vector<double> numbers(const std::string& json, const std::string& name) {
    std::vector<double> out;
    const std::string text = member(json, name);
    for (const char* at = text.c_str(); *at != '\0';) {
      char* end = nullptr;
      const double x = std::strtod(at, &end);
      if (end != at) out.push_back(x);
      at = end != at ? end : at + 1;
    }
    return out;
  }
  static std::vector<std::string> names(const std::string& json, const std::string& name) {
    std::vector<std::string> out;
    const std::string text = member(json, name), key = "\"name\": \"";
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
      const std::size_t begin = at + key.size();
      out.push_back(text.substr(begin, text.find('"', begin) - begin));
    }
    return out;
  }
};

}  // namespace check
