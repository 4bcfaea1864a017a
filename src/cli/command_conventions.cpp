// `tiltrotor conventions`: units, axes and signs.

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

namespace {

constexpr const char* text =
    R"(Units       SI and radians inside; files and command line in SI with angles in degrees. Every column name ends
            in its unit (speed_mps, pitch_deg, power_kw, long_stick_in). State files are SI with radians.
Body axes   x forward, y right, z down (ISO 1151, AIAA R-004), origin at the CG of the given mast angle. Attitude:
            Euler angles in the order yaw, pitch, roll.
Air         u, v, w, speed along the heading, climb rate and position: relative to the undisturbed air, which may drift
            over the ground steadily. gust_u, gust_v, gust_w (body axes): velocity of the air at the aircraft relative
            to that. Loads, airspeed (speed_mps), angle of attack and sideslip: relative to the air at the aircraft,
            velocity - gust.
Mast angle  mast_deg: 0 helicopter, 90 airplane. (NASA's nacelle angle is 90 - mast_deg.)
Rotors      right counter-clockwise seen from above, left clockwise. Each has a frame of its own, mirrored for the
            left rotor: x aft, y to the advancing side, z up the shaft. In symmetric flight both read the same.
Flapping    b1c > 0 tilts the disk forward, b1s > 0 raises the advancing side.
Inflow      n0, nc, ns over tip speed: mean, longitudinal and lateral harmonic at the tip.
Collective  collective75_deg: blade pitch at 0.75 R, mean of both rotors; collective_root_deg: at the root.
Inceptors   long_stick_in 0..9.6, neutral 4.8, larger is forward, in columns and messages of trim; lat_stick_in and
            pedal_in from neutral, + right. Increments of the longitudinal stick, linear models and the C interface
            count it from neutral, -4.8..4.8: long_stick, lon_in, long_stick_from_neutral_in = long_stick_in - 4.8.
Controls    long_cyclic > 0 tilts both disks forward; diff_* is (right - left)/2; elevator > 0 trailing edge down;
            aileron > 0 rolls right; rudder > 0 nose right.
Sideslip    sideslip_deg > 0: wind from the right.
Load factor load_factor of trim: force of air and rotors normal to the flight path over weight, 1 in level flight.
            (The C interface gives what an accelerometer shows: minus the specific force along body z, over gravity.)
Loads       force on the aircraft and moment about the CG, body axes, without weight.
States      u v w p q r phi theta psi | b1c b1s db1c db1s n0 nc ns of the right rotor (_R) | of the left rotor (_L) |
            eps, the lagged wing downwash at the tail.
Files       CSV is RFC 4180 in UTF-8, a byte-order mark allowed, one record a line. --states reads what trim and respond
            print. Numbers of trim, modes, respond and rotor smaller than 1e-12 (but residual) are rounding and printed as 0.
)";

int run(const Arguments&) {
  Sink sink("-", "");
  sink.write(text);
  sink.finish();
  return exit_success;
}

}  // namespace

Command conventions_command() {
  return {"conventions",
          "units, axes and signs",
          "Prints units, axes, signs and names used everywhere.\n",
          "tiltrotor conventions",
          {},
          run};
}

}  // namespace tiltrotor::cli
