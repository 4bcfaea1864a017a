// Rates and readings of the whole vehicle along directions: against a complex step through the same text.
#include "tiltrotor/analysis/linear/vehicle_direction.hpp"

#include "somewhere.hpp"

using namespace vehicle_case;

namespace {

struct Worst {
  double error = 0;
  const char* row = "";
};

double size_of(const Variable& variable) {
  return variable.kind == VariableKind::power ? variable.facts().bend : 1.0;
}

// Along every state and input at once, those included that a linear model leaves out, each by some of the distance over
// which the model bends.
void compare_direction(const Somewhere& at, Dice& dice, VehicleDirectionWorkspace<double>& work,
                       Worst& worst) {
  double dx[vehicle_state_count], du[vehicle_input_count];
  const auto some = [&dice](const Variable& variable) { return dice.between(-1, 1) * variable.facts().bend; };
  for (int i = 0; i < vehicle_state_count; ++i) {
    const bool filter = vehicle_variable(i).kind == VariableKind::gust_filter;
    dx[i] = filter ? 0 : some(vehicle_variable(i));
  }
  for (int j = 0; j < vehicle_input_count; ++j) du[j] = some(vehicle_input(j));
  Change found;
  Configuration<double> c = at.c;
  if (!CHECK(vehicle_direction(at.v, c, at.x, at.s, at.u, dx, du, work, found.of, found.readings) ==
             Status::ok))
    return;
  const Change expected = complex_step(at, dx, du);
  // Of the power of an engine at a limit the rest of two large numbers is left: over the size of a power, then.
  const auto compare = [&worst](double a, double b, double bend, const char* row) {
    const double error = std::fabs(a - b) / std::max({1.0, bend, std::fabs(b)});
    if (error > worst.error) worst = {error, row};
  };
  for (int i = 0; i < vehicle_state_count; ++i)
    compare(found.of[i], expected.of[i], size_of(vehicle_variable(i)), vehicle_variable(i).name);
  for (int i = 0; i < Instruments<double>::kCount; ++i)
    compare(found.readings[i], expected.readings[i], 1, "reading");
}

}  // namespace

TEST(vehicle_direction_equals_complex_step) {
  static VehicleDirectionWorkspace<double> work;
  Dice dice(6);
  Worst worst[3];
  for (int k = 0; k < 60; ++k) {
    const Governor governor = static_cast<Governor>(k % 3);
    const Somewhere at = somewhere(dice, governor);
    if (governor == Governor::ideal && !is_governed(at)) continue;
    compare_direction(at, dice, work, worst[k % 3]);
  }
  for (const Worst& w : worst) {
    NOTE("governor off, ideal, pi: worst " << w.error << " of " << w.row);
    CHECK_LT(w.error, 1e-11);
  }
}
