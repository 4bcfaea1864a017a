// One line that says which field of a setup is out of range, and its range.
#pragma once

#include "tiltrotor/math/sentence.hpp"
#include "tiltrotor/model/setup/setup_range.hpp"

namespace tiltrotor {

// "mass 2000 kg lies outside 3000..10000 kg"; nothing for a setup without fault. Writes at most capacity - 1
// characters, 80 are enough, and a terminating zero; returns the length.
template <class R>
int explain(const SetupFault<R>& fault, char* text, int capacity) {
  Sentence sentence(text, capacity);
  if (fault.field == SetupField::none) return 0;
  const char* const unit = setup_field_unit(fault.field);
  const char* const space = unit[0] == '\0' ? "" : " ";
  const auto value = static_cast<double>(fault.value);
  const double nearest =
      static_cast<double>(fault.value < fault.range.low ? fault.range.low : fault.range.high);
  const bool reads_alike = std::fabs(value - nearest) < 0.01;
  sentence << setup_field_name(fault.field) << " ";
  sentence.number(value, reads_alike ? Sentence::decimals_apart(value, nearest) : 0) << space << unit;
  sentence << " lies outside " << (fault.field == SetupField::azimuth_stations ? "0 or " : "");
  sentence.number(static_cast<double>(fault.range.low)) << "..";
  sentence.number(static_cast<double>(fault.range.high)) << space << unit;
  return sentence.length();
}

}  // namespace tiltrotor
