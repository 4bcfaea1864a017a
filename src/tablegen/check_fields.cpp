// Numbers of an aircraft that must fit each other.
#include "tablegen/aircraft_fields.hpp"

namespace tablegen {

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

struct Inside {
  const char *entry, *low, *high, *unit;
};
constexpr Inside kInside[] = {{"weight_gross", "mass_min", "mass_max", "kg"},
                              {"SL_CG_aft_helicopter", "cg_station_min", "cg_station_max", "m"},
                              {"WL_CG_helicopter", "cg_waterline_min", "cg_waterline_max", "m"},
                              {"rotor_rpm_helicopter", "rotor_speed_min", "rotor_speed_max", "rad/s"},
                              {"rotor_rpm_airplane", "rotor_speed_min", "rotor_speed_max", "rad/s"}};

}  // namespace

void check_fields(const Entries& entries) {
  for (std::size_t i = 0; i + 1 < kFields.size(); ++i) {
    if (!ends_with(kFields[i].field, ".low")) continue;
    const Field& low = kFields[i];
    const Field& high = kFields[i + 1];
    if (!(entries.in(low.entry, low.unit) < entries.in(high.entry, high.unit)))
      entries.refuse(high.entry, std::string("'") + high.entry + "' is not above '" + low.entry + "'");
  }
  for (const Inside& one : kInside) {
    const double value = entries.in(one.entry, one.unit);
    if (!(value >= entries.in(one.low, one.unit) && value <= entries.in(one.high, one.unit)))
      entries.refuse(one.entry, std::string("'") + one.entry + "' lies outside '" + one.low + "' and '" +
                                    one.high + "'");
  }
  const double blades = entries.in("rotor_blades", "count");
  constexpr double fewest = 3;  // two have no cyclic harmonics of their own
  constexpr double most = 12;
  if (!(blades >= fewest && blades <= most) || blades != static_cast<int>(blades))
    entries.refuse("rotor_blades", "a gimballed rotor has 3 to 12 blades");
  if (entries.in("engine_count", "count") != 2)
    entries.refuse("engine_count", "the systems have an engine beside each rotor: 2");
}

}  // namespace tablegen
