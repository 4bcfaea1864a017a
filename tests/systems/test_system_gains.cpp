// Tables of gains are what their rule makes of this model: recomputed at the flights that they name. The rule itself is
// held against the poles that it places by tests/systems/test_governor.cpp and test_augmentation.cpp.
#include "tiltrotor/analysis/linear/system_gains.hpp"
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

struct Named {
  double mast, speed;
};
constexpr Named kFlights[] = {{0, 0}, {15, 40}, {30, 60}, {45, 70}, {60, 75}, {75, 85}, {90, 100}};

}  // namespace

TEST_OF_XV15(system_gains_are_those_of_the_tables) {
  static SystemGainsWorkspace<double> work;
  const SystemTables<double>& tables = aircraft_data<double>().systems;
  double worst = 0;
  for (const Named& at : kFlights) {
    const Configuration<double> c = configuration(at.mast);
    const TrimResult<double> r = trimmed(c, level(at.speed));
    CHECK(is_trimmed(r.status));
    SystemGains<double> g;
    CHECK(system_gains(c, r.state, r.controls, work, g) == Status::ok);
    const auto written = [&at](const Table<double, 1>& table) {
      return lookup(table, Interpolation::c1, at.mast);
    };
    const auto compare = [&](double found, const Table<double, 1>& table) {
      CHECK_REL(found, written(table), 0.01);
      worst = std::max(worst, std::fabs(found / written(table) - 1));
    };
    compare(g.pitch, tables.augmentation.pitch);
    compare(g.roll, tables.augmentation.roll);
    compare(g.yaw, tables.augmentation.yaw);
    compare(g.integral, tables.governor.integral);
    if (written(tables.governor.proportional) > 0) {
      compare(g.proportional, tables.governor.proportional);
    } else {
      CHECK_LE(g.proportional, 0);
    }
  }
  NOTE("worst " << 100 * worst << " percent");
}
