#include "cli/units.hpp"

#include <algorithm>
#include <cmath>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "cli/flight_options.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"
#include "tiltrotor/model/airframe/airflow.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double kPound = 0.45359237;                       // kg
constexpr double kPoundForce = kPound * 9.80665;            // N
constexpr double kHorsepower = 0.55 * kFoot * kPoundForce;  // kW: 550 ft lbf/s

using Quantity = std::vector<UnitOfMeasure>;

// Its own unit first. Radians cannot be chosen: elevator_rad is an input that is added, elevator_deg where it stands.
const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {
      {{"mps", "m/s", "mps", 1}, {"knots", "kt", "kt", kKnot<double>}},
      {{"metres", "m", "m", 1}, {"feet", "ft", "ft", kFoot}},
      {{"kilograms", "kg", "kg", 1}, {"pounds", "lb", "lb", kPound}},
      {{"newtons", "N", "n", 1}, {"pounds", "lbf", "lbf", kPoundForce}},
      {{"kilowatts", "kW", "kw", 1}, {"horsepower", "hp", "hp", kHorsepower}},
      {{"", "deg", "deg", 1}, {"", "rad", "rad", 1 / kRadPerDeg<double>}},
      {{"", "deg/s", "degps", 1}, {"", "rad/s", "radps", 1 / kRadPerDeg<double>}},
      {{"", "rpm", "rpm", 1}, {"", "rad/s", "radps", 1 / kRpm}},
  };
  return all;
}

// The quantity of a sign, or one of its own.
Quantity quantity_of(const char* sign) {
  for (const Quantity& quantity : quantities())
    if (sign == std::string(quantity.front().sign)) return quantity;
  return {{"", sign, "", 1}};
}

bool ends_in(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string without_end(const std::string& text, const std::string& end) {
  return text.substr(0, text.size() - end.size());
}

// Rounded inward to three decimals, so that what a message shows is allowed.
Range range_in(const UnitOfMeasure& unit, const Range& range) {
  if (unit.size == 1) return range;
  constexpr double decimals = 1e3;
  return {std::ceil(range.low / unit.size * decimals) / decimals,
          std::floor(range.high / unit.size * decimals) / decimals, unit.sign};
}

}  // namespace

InUnit in_own_unit(const std::string& column) {
  for (const Quantity& quantity : quantities())
    for (std::size_t k = 1; k < quantity.size(); ++k)
      if (const std::string end = std::string("_") + quantity[k].column; ends_in(column, end))
        return {without_end(column, end) + "_" + quantity.front().column, quantity[k].size, quantity[k].sign};
  return {column, 1, ""};
}

std::vector<std::string> unit_words() {
  std::vector<std::string> words;
  for (const Quantity& quantity : quantities())
    for (const UnitOfMeasure& unit : quantity)
      if (*unit.word != '\0' && std::find(words.begin(), words.end(), unit.word) == words.end())
        words.emplace_back(unit.word);
  return words;
}

// A sign serves as its word: kt as knots.
Units::Units(const std::string& text, const std::string& where) {
  for (const std::string& part : split(text, ',')) {
    std::string word(csv::trimmed(part));
    for (const Quantity& quantity : quantities())
      for (const UnitOfMeasure& unit : quantity)
        if (*unit.word != '\0' && word == unit.sign) word = unit.word;
    const std::vector<std::string> known = unit_words();
    words_.push_back(known[place_of(word, known, where)]);
  }
  for (const Quantity& quantity : quantities()) {
    const auto chosen = std::count_if(quantity.begin(), quantity.end(),
                                      [&](const UnitOfMeasure& unit) { return is_chosen(unit); });
    if (chosen > 1)
      throw UsageError(where + ": " + quantity[0].word + " and " + quantity[1].word +
                       " are units of the same quantity; choose one");
  }
}

bool Units::is_chosen(const UnitOfMeasure& unit) const {
  return std::find(words_.begin(), words_.end(), unit.word) != words_.end();
}

InUnit Units::column(const std::string& own) const {
  for (const Quantity& quantity : quantities())
    if (const std::string end = std::string("_") + quantity.front().column; ends_in(own, end))
      for (const UnitOfMeasure& unit : quantity)
        if (is_chosen(unit)) return {without_end(own, end) + "_" + unit.column, unit.size, unit.sign};
  return {own, 1, ""};
}

InUnit Units::sign(const std::string& own) const {
  for (const UnitOfMeasure& unit : quantity_of(own.c_str()))
    if (is_chosen(unit)) return {unit.sign, unit.size, unit.sign};
  return {own, 1, ""};
}

UnitOfMeasure Units::take_unit(std::string& text, const std::string& where, const Range& range) const {
  const Quantity quantity = quantity_of(range.unit);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto chosen = std::find_if(quantity.begin(), quantity.end(),
                                   [&](const UnitOfMeasure& unit) { return is_chosen(unit); });
  const UnitOfMeasure otherwise = chosen == quantity.end() ? quantity.front() : *chosen;
  std::size_t end = text.find_last_of("0123456789.");
  if (end == std::string::npos || ++end == text.size()) return otherwise;
  const std::string sign(csv::trimmed(text.substr(end)));
  if (sign.empty() || !is_letter(sign[0])) return otherwise;
  std::vector<std::string> signs;
  for (const UnitOfMeasure& unit : quantity) {
    if (sign == unit.sign) {
      text.resize(end);
      return unit;
    }
    if (*unit.sign != '\0') signs.emplace_back(unit.sign);
  }
  throw UsageError(where + ": " + quoted(text) + " is not a number" +
                   (signs.empty() ? "" : ", alone or with " + one_of(signs)) + did_you_mean(sign, signs) +
                   "; give " + range_text(range_in(otherwise, range)));
}

double Units::number(const std::string& text, const std::string& where, const Range& range) const {
  std::string digits = text;
  const UnitOfMeasure unit = take_unit(digits, where, range);
  return parse_number(digits, where, range_in(unit, range)) * unit.size;
}

std::vector<double> Units::sweep(const std::string& text, const std::string& where,
                                 const Range& range) const {
  std::vector<double> values;
  for (std::string item : split(text, ',')) {
    if (item.empty()) return parse_sweep(text, where, range);  // throws
    const UnitOfMeasure unit = take_unit(item, where, range);
    for (const double value : parse_sweep(item, where, range_in(unit, range)))
      values.push_back(value * unit.size);
  }
  require_few_values(values.size(), where);
  return values;
}

}  // namespace tiltrotor::cli
