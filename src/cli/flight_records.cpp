#include "cli/flight_records.hpp"

#include <algorithm>

#include "cli/state_columns.hpp"

namespace tiltrotor::cli {

namespace {

constexpr const char* kSettings[] = {"altitude_m", "mass_kg",   "cg_sl_in",
                                     "flap_deg",   "rotor_rpm", kWarmerColumn};

struct Condition {
  const char* column;
  double (*of_case)(const FlightCase&);
  double (*of_flight)(const TrimmedFlight&);
};
const Condition conditions[] = {
    {"mast_deg", [](const FlightCase& f) { return f.mast_deg; },
     [](const TrimmedFlight& f) { return f.mast_deg; }},
    {"speed_mps", [](const FlightCase& f) { return f.flight.speed; },
     [](const TrimmedFlight& f) { return f.flight.speed; }},
    {"climb_deg", [](const FlightCase& f) { return f.climb_deg; },
     [](const TrimmedFlight& f) { return f.climb_deg; }},
    {"sideslip_deg", [](const FlightCase& f) { return f.azimuth_deg ? 0 : f.sideslip_deg; },
     [](const TrimmedFlight& f) { return f.sideslip_deg; }},
    {"azimuth_deg", [](const FlightCase& f) { return f.azimuth_deg.value_or(0); },
     [](const TrimmedFlight& f) { return f.azimuth_deg.value_or(0); }},
    {"turn_rate_degps", [](const FlightCase& f) { return f.turn_rate_degps; },
     [](const TrimmedFlight& f) { return f.turn_rate_degps; }},
};

template <class Item, class Value>
bool differ(const std::vector<Item>& items, const Value& value) {
  return std::any_of(items.begin(), items.end(),
                     [&](const Item& item) { return value(item) != value(items.front()); });
}

const Condition* condition_of(const std::string& name) {
  const Condition* const found = std::find_if(std::begin(conditions), std::end(conditions),
                                              [&](const Condition& c) { return name == c.column; });
  return found == std::end(conditions) ? nullptr : found;
}

double value_of(const std::string& name, const TrimmedFlight& flight) {
  if (const Condition* const condition = condition_of(name)) return condition->of_flight(flight);
  for (const TrimTarget& target : flight.targets)
    if (name == target.held) return target.value;
  if (name == kWarmerColumn) return flight.setup->given(name).value_or(0);
  return flight.setting(name);
}

// A state by the name of the model whose printed column stands there already.
bool is_printed_state(const std::string& name, const std::vector<std::string>& columns) {
  for (int i = 0; i < state_count; ++i)
    if (name == kStateVariables[i].name)
      return std::find(columns.begin(), columns.end(), state_columns(i).back()) != columns.end();
  return false;
}

}  // namespace

SweptColumns::SweptColumns(const Arguments& arguments, const std::vector<SetupOptions>& setups,
                           const std::vector<std::string>& own) {
  const auto add = [&](const std::string& name) {
    if (std::find(own.begin(), own.end(), name) == own.end()) names_.push_back(name);
  };
  for (const char* setting : kSettings)
    if (differ(setups, [&](const SetupOptions& setup) { return setup.given(setting); })) add(setting);
  const std::vector<FlightCase> cases = flight_cases(arguments, setups.size());
  for (const Condition& condition : conditions)
    if (differ(cases, condition.of_case)) add(condition.column);
  for (std::size_t k = 0; k < cases.front().targets.size(); ++k)
    if (differ(cases, [&](const FlightCase& f) { return f.targets[k].value; }) &&
        !is_printed_state(cases.front().targets[k].held, own))
      add(cases.front().targets[k].held);
}

std::vector<double> SweptColumns::values(const TrimmedFlight& flight) const {
  std::vector<double> values;
  for (const std::string& name : names_) values.push_back(value_of(name, flight));
  return values;
}

Row SweptColumns::cells(const TrimmedFlight& flight) const {
  Row row;
  for (const double value : values(flight)) row.emplace_back(as_given(value));
  return row;
}

std::vector<std::string> swept_names() {
  std::vector<std::string> names;
  for (const char* setting : kSettings) names.emplace_back(setting);
  for (const Condition& condition : conditions) names.emplace_back(condition.column);
  return names;
}

FlightRecords::FlightRecords(const Arguments& arguments, const std::vector<SetupOptions>& setups,
                             Output& output, const std::vector<std::string>& own, int digits)
    : swept_(arguments, setups, own),
      records_(output.records(
          [&] {
            std::vector<std::string> all = own;
            all.insert(all.end(), swept_.names().begin(), swept_.names().end());
            return all;
          }(),
          digits)) {}

Row FlightRecords::complete(const TrimmedFlight& flight, Row row) const {
  const Row swept = swept_.cells(flight);
  row.insert(row.end(), swept.begin(), swept.end());
  return row;
}

}  // namespace tiltrotor::cli
