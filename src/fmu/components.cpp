// Outputs of the components: loads, and angles of the flow at wing and tail. The C interface does not have them; the unit, which
// holds the whole library, reads them by the C++ functions that the command line uses. Slopes are those of dual numbers.
#include "fmu/instance.hpp"
#include "library/c_system_model.hpp"
#include "library/c_words.hpp"
#include "library/component_readings.hpp"
#include "tiltrotor/analysis/linear/vehicle_direction.hpp"

namespace tiltrotor_fmu {

namespace {

using namespace tiltrotor;
using c_interface::Sim;
using Directions = VehicleDirectionWorkspace<double>;
using Seeded = Directions::T;

static_assert(kLoadedComponents == component_count + 1 && kNumbersOfLoads == Loads<double>::kCount);
static_assert(kOutputJets == kOutputLoads + static_cast<int>(Component::engine_jets) * kNumbersOfLoads);

struct ValueWork {
  Configuration<double> configuration;
  VehicleReadings<double> now;
  ComponentReadings<double> found;
};
struct SlopeWork {
  Configuration<double> configuration;
  Directions directions;
  ComponentReadings<Seeded> found;
  double rates[TR_STATES], readings[TR_OUTPUTS];
};
static_assert(sizeof(ValueWork) + c_interface::kWorkAlignment <= sizeof(tr_work));
static_assert(sizeof(SlopeWork) + c_interface::kWorkAlignment <= sizeof(tr_work));

// put(place of the output, number), one after another; false when one is not finite.
template <class T, class Put>
bool put_components(const Configuration<T>& c, const DerivativeSteps<T>& steps, ComponentReadings<T>& found,
                    Put&& put) {
  read_components(c, steps, found);
  bool finite = put(kOutputWingAngle, found.airframe.wing_alpha);
  finite &= put(kOutputTailAngle, htail_angle_of_attack(c, steps, found));
  int place = kOutputLoads;
  const auto put_loads = [&](const Loads<T>& of) {
    Loads<T>::each(of, [&](const T& number) { finite &= put(place++, number); });
  };
  Loads<T> all{};
  for (const Loads<T>& each : found.loads.component) {
    put_loads(each);
    all = all + each;
  }
  put_loads(all);
  return finite;
}

}  // namespace

tr_status read_component_outputs(Instance& i, double (&y)[kOutputs]) {
  const Sim& s = *c_interface::opened(&i.flight.sim);
  auto& work = c_interface::workspace_in<ValueWork>(&i.work);
  Configuration<double>& c = c_interface::equipped_in_air(s, work.configuration);
  const ConfigurationSetting<double> base = c.setup;
  work.now.read({s.systems.vehicle, s.systems.state, base, c}, c, c_interface::evaluated_state(s),
                s.systems.state, s.u, 0);
  const bool finite = put_components(c, work.now.steps, work.found, [&y](int place, double number) {
    y[place] = number;
    return is_finite(number);
  });
  return finite ? TR_OK : TR_NOT_FINITE;
}

tr_status slopes_of_component_outputs(Instance& i, const double* dx, const double* du,
                                      double (&dy)[kOutputs]) {
  const Sim& s = *c_interface::opened(&i.flight.sim);
  auto& work = c_interface::workspace_in<SlopeWork>(&i.work);
  Configuration<double>& c = c_interface::equipped_in_air(s, work.configuration);
  const Status status =
      vehicle_direction(s.systems.vehicle, c, c_interface::evaluated_state(s), s.systems.state, s.u, dx, du,
                        work.directions, work.rates, work.readings);
  if (status != Status::ok) return c_interface::translated(status);
  const Directions& at = work.directions;
  const bool finite =
      put_components(at.configuration, at.steps, work.found, [&](int place, const Seeded& number) {
        dy[place] = at.slope(number, 0);
        return is_finite(number.v) && is_finite(dy[place]);
      });
  return finite ? TR_OK : TR_NOT_FINITE;
}

}  // namespace tiltrotor_fmu
