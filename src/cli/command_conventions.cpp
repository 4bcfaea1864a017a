// `tiltrotor conventions`: units, axes and signs.

#include <algorithm>
#include <cstring>

#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "text/sink.hpp"
#include "tiltrotor/model/variables/controls.hpp"
#include "tiltrotor/systems/system_state.hpp"

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
Load factor load_factor, of trim and of the C interface alike: force of air and rotors normal to the motion through the
            air over weight, 1 in level flight, < 0 where it pushes down; at rest all of the force.
Loads       force on the aircraft and moment about the CG, body axes, without weight.
Names       _R right, _L left rotor; eps: lagged wing downwash at the tail; b0, db0: coning (coning_states); north, east,
            down: position (position_states).
Files       CSV is RFC 4180 in UTF-8, a byte-order mark allowed, one record a line. --states reads what trim and respond
            print. Numbers of trim, modes, respond and rotor smaller than 1e-12 (but residual; bank, heading, place, sums over
            t seconds, 1e-12 t), and loads, rates and entries of A and B smaller than 1e-14 of the terms beside them, are
            rounding and printed as 0. What was given is printed as it was given. A speed below 1e-15 m/s is rest.
Model       model, in rows of trim and respond: the aircraft and the switches that differ from their defaults, isa_offset
            and engines as well. --states takes these two from the row, and tells on stderr where a row was made with
            another model than it is computed with.
)";

// "States      u v w": names in the order of files and arrays.
template <class Table>
std::string listed(const char* title, const Table& variables) {
  constexpr std::size_t indent = 12, width = 118;
  std::string lines, line = title;
  for (const Variable& variable : variables.row) {
    if (line.size() + 1 + std::strlen(variable.name) > width) {
      lines += line + "\n";
      line.clear();
    }
    line.resize(std::max(line.size() + 1, indent), ' ');
    line += variable.name;
  }
  return lines + line + "\n";
}

int run(const Arguments&) {
  Sink sink("-", "");
  sink.write(text);
  sink.write(listed("States", kStateVariables) + listed("Systems", kSystemVariables) +
             listed("Inputs", kControlVariables) + listed("Commands", kCommandVariables));
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
