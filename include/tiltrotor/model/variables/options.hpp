// Switches of the model: every modelling choice with an alternative, its default first.
#pragma once

#include "tiltrotor/math/tables/table.hpp"

namespace tiltrotor {

enum class BladeGrid : unsigned char { specification, realtime };    // radial and azimuth stations
enum class AzimuthMode : unsigned char { averaged, individual };     // rotor average or each blade
enum class FlapOrder : unsigned char { second, first };              // gimbal equations
enum class InflowShape : unsigned char { pitt_peters, uniform };     // three states or the mean alone
enum class DescentInflow : unsigned char { vortex_ring, momentum };  // mean inflow in the rotor's own wake
enum class InflowGradient : unsigned char { pitt_peters, coleman, white_blake };  // fore-aft
enum class RadialInflow : unsigned char { annular, constant };        // mean inflow along the blade
enum class ApparentMass : unsigned char { impermeable, loaded };      // 8/(3 pi) or 128/(75 pi)
enum class WakeModel : unsigned char { geometric, gtrs_empirical };   // immersed area of the wing
enum class WashFactor : unsigned char { constant, vortex_cylinder };  // wash speed on the immersed wing
enum class WakeLoadFactor : unsigned char { calibrated, gtrs };       // K_FW
enum class MastDrag : unsigned char { cosine, cross_flow, linear };   // wing-pylon CD between mast 0 and 90
enum class RotorLiftFlaps : unsigned char { full, any };  // flaps that the wing's rotor-induced lift needs
enum class TailWash : unsigned char { tables, closed_form };          // rotor wash at the horizontal tail
enum class TailPressure : unsigned char { none, by_mast, constant };  // no K_HNU, faded in, or always
enum class NacelleMass : unsigned char { printed_cg, quoted };        // 3985 lb or 4200 lb
enum class InertiaSet : unsigned char { simulation, design_1975, flown };
enum class FinArea : unsigned char { drawings, report };  // 25.25 or 20.25 ft^2 a panel
enum class ChordSource : unsigned char { cutout, text, camrad };
enum class TwistSource : unsigned char { table, linear };
enum class ElevatorGearing : unsigned char { aircraft, printed_runs };  // 4.167 or 4.735 deg/in
// off: rotor speed and collective are what they are set to, the power is what it takes. ideal: the speed is held, and
// the collective is that which takes the power of the engines. pi: the speed is a state, the governor adds collective.
// A choice of linear models and flights, systems/vehicle.hpp: the airframe itself does not ask.
enum class Governor : unsigned char { off, ideal, pi };
// The shaft between the rotors: both turn alike, or, with governor pi, each for itself.
enum class Interconnect : unsigned char { rigid, twists };

struct Options {
  Interpolation tables = Interpolation::c1;
  BladeGrid grid = BladeGrid::specification;
  int grid_refinement = 1;   // multiplies the radial stations of the specification grid, 1..4
  int azimuth_stations = 0;  // 0: the grid's own number; else 3..72
  AzimuthMode azimuth = AzimuthMode::averaged;
  FlapOrder flapping = FlapOrder::second;
  bool flap_angular_acceleration = false;  // keep the hub's angular acceleration in the flap equations
  bool coning_states = false;              // coning as two states a rotor instead of a constant
  bool mast_cant = true;
  double hub_spring_factor = 1;  // multiplies the hub spring
  InflowShape inflow = InflowShape::pitt_peters;
  InflowGradient inflow_gradient = InflowGradient::pitt_peters;
  RadialInflow radial_inflow = RadialInflow::annular;
  DescentInflow descent_inflow = DescentInflow::vortex_ring;
  ApparentMass apparent_mass = ApparentMass::impermeable;
  bool disk_plane_inflow = false;   // through-flow normal to the tilted disk instead of the shaft
  double induced_power_factor = 0;  // kappa_i; 0: the value of the aircraft's choices
  bool side_by_side = false;        // X_SS of table 1-III on the thrust that forces the mean inflow
  bool sideward_flight = false;     // X_SF of table 1-II likewise
  WakeModel wake = WakeModel::geometric;
  bool wake_fade = true;           // speed fade of the geometric wake
  bool wake_fade_airplane = true;  // the fade holds in airplane mode too
  WashFactor wash = WashFactor::constant;
  WakeLoadFactor wake_load = WakeLoadFactor::calibrated;
  MastDrag mast_drag = MastDrag::cosine;
  bool rotor_lift_on_wing = true;  // K_RW: rotor-induced lift of the free wing
  RotorLiftFlaps rotor_lift_flaps = RotorLiftFlaps::full;
  bool engine_jets = false;         // net thrust of the engines' jets, with the drag of the air they take in
  bool wing_rate_velocity = false;  // add the velocity due to body rates at the free wing's centre
  bool downwash_lag = true;         // wing downwash reaches the tail through a state
  TailWash tail_wash = TailWash::tables;
  TailPressure tail_pressure = TailPressure::none;
  bool tail_sideslip_loss = false;  // table 5-VI on the tail loads
  NacelleMass nacelle_mass = NacelleMass::printed_cg;
  InertiaSet inertia = InertiaSet::simulation;
  FinArea fin_area = FinArea::drawings;
  ChordSource chord = ChordSource::cutout;
  TwistSource twist = TwistSource::table;
  bool cyclic_rigging = true;   // longitudinal cyclic bias that grows with mast angle
  bool stall_delay = false;     // lift that rotation keeps beyond stall
  bool lateral_cyclic = false;  // lateral cyclic schedule with airspeed, tables 8a-VII and 8a-VIII
  ElevatorGearing elevator_gearing = ElevatorGearing::aircraft;
  Governor governor = Governor::off;
  Interconnect interconnect = Interconnect::rigid;
  bool position_states = false;  // earth position among the active states
};

}  // namespace tiltrotor
