#include "tablegen/entries.hpp"

#include <cmath>

#include "tablegen/fault.hpp"
#include "tablegen/units.hpp"

namespace tablegen {

namespace {

constexpr double kSiTolerance = 1e-6;  // the SI column is printed with seven digits

const Unit& unit_of(const Csv& csv, const Row& row, std::size_t column) {
  const Unit* const unit = find_unit(row.cell[column]);
  if (unit == nullptr) throw Fault{csv.file, row.line, "unknown unit '" + row.cell[column] + "'"};
  return *unit;
}

}  // namespace

Csv Entries::read_named(const std::string& file) {
  Csv csv = read_csv(file);
  ends_.push_back({file, csv.rows.back().line});
  return csv;
}

void Entries::add(const Csv& csv, const Row& row, const Entry& entry) {
  const std::string& name = row.cell[csv.column("name")];
  if (name.empty()) throw Fault{csv.file, row.line, "entry without a name"};
  const auto [at, added] = positions_.insert({name, {csv.file, row.line}});
  if (!added)
    throw Fault{csv.file, row.line,
                "'" + name + "' appears twice, first in line " + std::to_string(at->second.line) + " of " +
                    at->second.file};
  if (!entry.text.empty()) entries_[name] = entry;
}

void Entries::read_aircraft(const std::string& file) {
  const Csv csv = read_named(file);
  const std::size_t value = csv.column("value");
  const std::size_t unit = csv.column("unit");
  const std::size_t si_value = csv.column("SI_value");
  const std::size_t si_unit = csv.column("SI_unit");
  for (const Row& row : csv.rows) {
    const Unit& from = unit_of(csv, row, unit);
    if (row.cell[si_unit] != from.si)
      throw Fault{csv.file, row.line,
                  "SI unit of " + row.cell[unit] + " is " + from.si + ", not " + row.cell[si_unit]};
    Entry entry{row.cell[value], 0, row.cell[unit]};
    if (entry.text.empty() != row.cell[si_value].empty())
      throw Fault{csv.file, row.line, "value and SI value must be given both or left empty both"};
    if (!entry.text.empty()) {  // an empty value means that no source has it
      entry.value = number(csv, row, value);
      const double expected = number(csv, row, si_value);
      const double si = entry.value * from.to_si;
      if (!std::isfinite(si) || std::abs(si - expected) > kSiTolerance * std::abs(si))
        throw Fault{csv.file, row.line,
                    entry.text + " " + entry.unit + " is " + std::to_string(si) + " " + from.si +
                        ", the SI value says " + row.cell[si_value]};
    }
    add(csv, row, entry);
  }
}

void Entries::read_choices(const std::string& file) {
  const Csv csv = read_named(file);
  const std::size_t value = csv.column("value");
  const std::size_t unit = csv.column("unit");
  const std::size_t reason = csv.column("reason");
  for (const Row& row : csv.rows) {
    unit_of(csv, row, unit);
    const double parsed = number(csv, row, value);
    if (row.cell[reason].empty()) throw Fault{csv.file, row.line, "a choice needs its reason"};
    add(csv, row, {row.cell[value], parsed, row.cell[unit]});
  }
}

const Entry& Entries::operator[](const std::string& name) const {
  const auto entry = entries_.find(name);
  if (entry != entries_.end()) return entry->second;
  const auto place = positions_.find(name);
  if (place != positions_.end())
    throw Fault{place->second.file, place->second.line, "'" + name + "' has no value"};
  std::string others;
  for (std::size_t i = 1; i < ends_.size(); ++i) others += " and in " + ends_[i].file;
  throw Fault{ends_.front().file, ends_.front().line, "entry '" + name + "' is missing here" + others};
}

double Entries::in(const std::string& name, const std::string& unit) const {
  const Entry& entry = (*this)[name];
  const Unit& from = *find_unit(entry.unit);
  const Unit* const to = find_unit(unit);
  if (to == nullptr || std::string(from.si) != to->si)
    refuse(name, "'" + name + "' in " + entry.unit + " cannot be turned into " + unit);
  return converted(entry.value, from, *to);
}

void Entries::refuse(const std::string& name, const std::string& message) const {
  const Position& place = positions_.at(name);
  throw Fault{place.file, place.line, message};
}

}  // namespace tablegen
