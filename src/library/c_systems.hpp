// Systems of an aircraft of the C interface, and the aircraft as they have put it.
#pragma once

#include "library/c_memory.hpp"

namespace tiltrotor::c_interface {

inline bool has_systems(const Sim& s) { return any_system(s.systems.vehicle.on); }

// What an evaluation at the present state finds. `c` is equipped, and put into what the systems ask for.
struct Found {
  DerivativeSteps<R> steps;
  State<R> rates;
  SystemState<R> system_rates;
  R weight_on_wheels;  // normal forces over weight
};
void evaluate(const Sim& s, Configuration<R>& c, Found& found);
// As one array, of TR_STATES.
void flatten_rates(const Found& found, R* rates);

// Commands and states after the configuration was set by hand, or a state was.
void follow_configuration(Sim& s);
// The configuration after system states were set. Unless TR_OK nothing is changed, and `blamed` is the place in tr_state of
// the one that is to blame.
tr_status follow_systems(Sim& s, int* blamed = nullptr);
// Of a tr_state; those of systems that are off stay zero.
void put_system_states(const R* states, Sim& s);
// Everything off, commands those of the configuration.
void reset_systems(Sim& s);
// What ground and a gear that is down do to a flight at (x, u), its wheels off the ground, put into `c`; whether they do
// anything.
bool meet_ground_in_flight(const Sim& s, State<R> x, const Controls<R>& u, Configuration<R>& c);
// All standing still in the steady flight that has been found.
void settle_systems(Sim& s);
// Velocity of the air at `arm` from the CG relative to the undisturbed air and to the gust that is felt everywhere, body axes,
// m/s: that of the wing and the turning of the air, turbulence included.
Vec3<R> gust_at(const Sim& s, const Vec3<R>& arm);
// A failed engine gives nothing whether the engines are among the systems or not.
int engines_that_run(const Sim& s);

void get_systems(const Sim& s, tr_systems& systems);
// Wind over the ground at the aircraft, north east down, m/s, with the ground and the shear of `v`, from the one told.
Vec3<R> wind_there(const Sim& s, const Vehicle<R>& v, const Vec3<R>& told_n);
// Velocity through the air when the wind has changed by so much and that over the ground has stayed; whether it may be.
bool keep_over_ground(const Sim& s, const Vec3<R>& change_n, Vec3<R>& velocity);
// Switches and commands alone; states as they are.
void put_switches(const tr_systems& systems, Sim& s);

// A and B of the whole, as tr_linearize. Where the library has none: TR_BAD_ARGUMENT.
struct LinearArrays;
tr_status linearize_systems(const Sim& s, tr_work* work, std::int32_t columns, tr_linear_shape* shape,
                            const LinearArrays& to, R* xdot);
// Along dx[TR_STATES] and du[TR_INPUTS], and C and D by rows, as tr_directional and tr_linearize_outputs.
tr_status direction_of_systems(const Sim& s, tr_work* work, const R* dx, const R* du, R* dxdot, R* dreadings);
struct OutputArrays {
  R* c;
  std::size_t c_length;
  R* d;
  std::size_t d_length;
};
tr_status outputs_of_systems(const Sim& s, tr_work* work, std::int32_t columns, const OutputArrays& to);
tr_status modes_of_systems(tr_work* work, const tr_linear_shape& shape, const R* a, tr_mode* modes,
                           std::size_t capacity, std::size_t* count);

}  // namespace tiltrotor::c_interface
