#include "tablegen/units.hpp"

namespace tablegen {

namespace {

// Definitions of 1959 (foot, pound), 1901 (standard gravity), 1929 (knot); hp is 550 ft lbf/s.
constexpr double kFoot = 0.3048;
constexpr double kInch = 0.0254;
constexpr double kPound = 0.45359237;
constexpr double kPoundForce = 4.4482216152605;
constexpr double kSlug = kPoundForce / kFoot;
constexpr double kHorsepower = 745.69987158227;
constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kPi = 3.14159265358979323846;
constexpr double kDegPerRad = kPi / 180;

constexpr Unit kUnits[] = {
    {"ND", 1, "ND"},
    {"count", 1, "count"},
    {"lb", kPound, "kg"},
    {"slug", kSlug, "kg"},
    {"kg", 1, "kg"},
    {"slug ft2", kSlug* kFoot* kFoot, "kg m2"},
    {"kg m2", 1, "kg m2"},
    {"slug ft2/deg", kSlug* kFoot* kFoot / kDegPerRad, "kg m2/rad"},
    {"kg m2/deg", 1 / kDegPerRad, "kg m2/rad"},
    {"kg m2/rad", 1, "kg m2/rad"},
    {"slug/ft3", kSlug / (kFoot * kFoot * kFoot), "kg/m3"},
    {"kg/m3", 1, "kg/m3"},
    {"in", kInch, "m"},
    {"ft", kFoot, "m"},
    {"m", 1, "m"},
    {"ft2", kFoot* kFoot, "m2"},
    {"m2", 1, "m2"},
    {"ft3", kFoot* kFoot* kFoot, "m3"},
    {"m3", 1, "m3"},
    {"deg", kDegPerRad, "rad"},
    {"degrees", kDegPerRad, "rad"},
    {"rad", 1, "rad"},
    {"1/deg", 1 / kDegPerRad, "1/rad"},
    {"1/rad", 1, "1/rad"},
    {"1/deg2", 1 / (kDegPerRad * kDegPerRad), "1/rad2"},
    {"1/rad2", 1, "1/rad2"},
    {"deg/in", kDegPerRad / kInch, "rad/m"},
    {"rad/in", 1 / kInch, "rad/m"},
    {"rad/m", 1, "rad/m"},
    {"deg/s", kDegPerRad, "rad/s"},
    {"rpm", kPi / 30, "rad/s"},
    {"rad/s", 1, "rad/s"},
    {"rad/s2", 1, "rad/s2"},
    {"ft/s", kFoot, "m/s"},
    {"kt", kKnot, "m/s"},
    {"m/s", 1, "m/s"},
    {"ft/s/deg", kFoot / kDegPerRad, "m/s/rad"},
    {"m/s/rad", 1, "m/s/rad"},
    {"ft/s2", kFoot, "m/s2"},
    {"m/s2", 1, "m/s2"},
    {"lb/ft2", kPoundForce / (kFoot * kFoot), "Pa"},
    {"Pa", 1, "Pa"},
    {"in lbf", kInch* kPoundForce, "N m"},
    {"N m", 1, "N m"},
    {"ft lbf/rad", kFoot* kPoundForce, "N m/rad"},
    {"ft lbf/deg", kFoot* kPoundForce / kDegPerRad, "N m/rad"},
    {"N m/rad", 1, "N m/rad"},
    {"ft lbf s/rad", kFoot* kPoundForce, "N m s/rad"},
    {"N m s/rad", 1, "N m s/rad"},
    {"N", 1, "N"},
    {"K", 1, "K"},
    {"hp", kHorsepower, "W"},
    {"W", 1, "W"},
    {"kW", 1000, "W"},
    {"lbf", kPoundForce, "N"},
    {"N", 1, "N"},
    {"lbf/hp", kPoundForce / kHorsepower, "N/W"},
    {"N/W", 1, "N/W"},
    {"slug/s", kSlug, "kg/s"},
    {"kg/s", 1, "kg/s"},
    {"slug/s/hp", kSlug / kHorsepower, "kg/J"},
    {"kg/J", 1, "kg/J"},
    {"lb/hp/h", kPound / (kHorsepower * 3600), "kg/J"},
    {"s", 1, "s"},
    {"1/s", 1, "1/s"},
    {"deg/s2", kDegPerRad, "rad/s2"},
    {"hp/s", kHorsepower, "W/s"},
    {"kW/s", 1000, "W/s"},
    {"W/s", 1, "W/s"},
    {"in s/rad", kInch, "m s/rad"},
    {"lbf/in", kPoundForce / kInch, "N/m"},
    {"N/m", 1, "N/m"},
    {"lbf s/in", kPoundForce / kInch, "N s/m"},
    {"N s/m", 1, "N s/m"},
};

}  // namespace

const Unit* find_unit(const std::string& name) {
  for (const Unit& unit : kUnits)
    if (name == unit.name) return &unit;
  return nullptr;
}

double converted(double value, const Unit& from, const Unit& to) {
  return &from == &to ? value : value * from.to_si / to.to_si;
}

}  // namespace tablegen
