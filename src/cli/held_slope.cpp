#include "cli/held_slope.hpp"

#include <algorithm>
#include <memory>

#include "cli/named_outputs.hpp"
#include "cli/trim_columns.hpp"
#include "tiltrotor/analysis/flight/instruments.hpp"

namespace tiltrotor::cli {

namespace {

struct Work {
  DerivativeSteps<Along> steps;
  Evaluation<Along> at;
  Instruments<Along> read;
  TrimmedFlight moved, still;  // what `trim` prints is linear in its results: of their slopes, and of none
};

template <template <class> class Shape>
void put_slopes(const Shape<Along>& from, Shape<double>& to) {
  Along all[sizeof from / sizeof(Along)];
  double slope[sizeof from / sizeof(Along)];
  flatten(from, all);
  for (std::size_t i = 0; i < sizeof slope / sizeof *slope; ++i) slope[i] = all[i].d;
  unflatten(slope, to);
}

// Slopes of what follows from state and controls: describe() of trim.hpp.
void describe(const Configuration<Along>& c, const State<Along>& x, const Controls<Along>& u,
              const Evaluation<Along>& at, TrimResult<double>& slope) {
  slope = {};
  put_slopes(x, slope.state);
  put_slopes(u, slope.controls);
  const Vec3<Along> v = x.velocity - u.gust;
  const BladeControls<Along> blades = mix_controls(c, u, v);
  for (const Side side : {right, left}) {
    slope.blades.collective[side] = blades.collective[side].d;
    slope.blades.long_cyclic[side] = blades.long_cyclic[side].d;
  }
  slope.blades.elevator = blades.elevator.d;
  slope.blades.aileron = blades.aileron.d;
  slope.blades.rudder = blades.rudder.d;
  if (length(v).v >= kLeastSpeed<double>) {
    slope.angle_of_attack = atan2(v.z, v.x).d;
    slope.sideslip = atan2(v.y, sqrt(square(v.x) + square(v.z))).d;
  }
  slope.wing_angle_of_attack = at.wing_alpha.d;
  slope.collective_root = (u.collective + blade_root_twist(c)).d;
  Vec3<Along> force{};
  for (const Loads<Along>& loads : at.loads.component) force = force + loads.force;
  slope.load_factor = load_factor((Along(1) / c.mass.mass) * force, v).d;
  Along thrust(0), download(0);
  for (const Side side : {right, left}) {
    const MastLoads<Along>& rotor = at.rotor[side].loads;
    const Along size = length(rotor.force_a);
    slope.thrust[side] = size.d;
    slope.power[side] = (rotor.torque * c.setup.rotor_speed).d;
    thrust += size;
    const Component wake = side == right ? Component::wing_wake_right : Component::wing_wake_left;
    download -= dot(at.loads[wake].force, c.hub[side].thrust_axis_b);
  }
  const Along least = Along(0.1 * kGravity<double>) * c.mass.mass;
  if (download.v > 0) slope.download_fraction = (download / (thrust.v > least.v ? thrust : least)).d;
}

}  // namespace

double held_slope(const TrimTarget& target, const TrimmedFlight& flight, const Configuration<Along>& c,
                  const State<Along>& x, const Controls<Along>& u) {
  if (target.held == "ny") return side_force(x).d;
  const auto work = std::make_unique<Work>();
  evaluate_aircraft(c, x, u, work->steps, work->at, Along(0));
  const std::vector<std::string> own = trim_quantities();
  if (std::find(own.begin(), own.end(), target.held) != own.end()) {
    work->moved = work->still = flight;
    work->still.trim = {};
    describe(c, x, u, work->at, work->moved.trim);
    const auto value = trim_quantity(target.held);
    return value(work->moved) - value(work->still);
  }
  const NamedOutput output = *output_named(target.held, target.held);
  if (output.reading < 0)
    return airframe_readings(c, x, work->steps, work->at.rates, {output.output}).front().d;
  read_instruments(c, x, work->steps, work->at.rates, work->read);
  Along all[Instruments<double>::kCount];
  flatten(work->read, all);
  return all[output.reading].d;
}

}  // namespace tiltrotor::cli
