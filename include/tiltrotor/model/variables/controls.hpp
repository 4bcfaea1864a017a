// Inputs of the aircraft: the pilot's inceptors, direct increments on blades and surfaces, and gusts.
//
// A new input is a member and its line in describe(). All act together: the increments add to what the
// gearing makes of the inceptors (control_mixing.hpp). So a linear model can have its columns in inceptor
// inches, in blade angles, or both.
#pragma once

#include "tiltrotor/math/vector.hpp"
#include "tiltrotor/model/variables/variables.hpp"

namespace tiltrotor {

template <class T>
struct Controls {
  T collective;        // mean blade pitch at 0.75 R, rad
  T long_stick;        // in from neutral, + forward
  T lat_stick;         // in from neutral, + right
  T pedal;             // in from neutral, + right
  T long_cyclic;       // B1 increment, rad, + disks forward
  T diff_collective;   // (right - left)/2 increment, rad
  T diff_long_cyclic;  // (right - left)/2 increment, rad
  T elevator;          // increment, rad, + trailing edge down
  T aileron;           // increment, rad, + rolls right
  T rudder;            // increment, rad, + nose right
  T lateral_cyclic;    // A1 increment of both rotors in their own frames, rad
  Vec3<T> gust;        // velocity of the air at the aircraft relative to the undisturbed air, body axes, m/s

  // Every input once, with what it is, in the order of files and arrays.
  template <class Self, class Visit>
  static constexpr void describe(Self& s, Visit&& visit) {
    using K = VariableKind;
    constexpr Plane lon = Plane::longitudinal;
    constexpr Plane lat = Plane::lateral;
    visit(s.collective, Variable{"collective", K::blade_pitch, lon});
    visit(s.long_stick, Variable{"long_stick", K::stick, lon});
    visit(s.lat_stick, Variable{"lat_stick", K::stick, lat});
    visit(s.pedal, Variable{"pedal", K::pedal, lat});
    visit(s.long_cyclic, Variable{"long_cyclic", K::blade_pitch, lon});
    visit(s.diff_collective, Variable{"diff_collective", K::blade_pitch, lat});
    visit(s.diff_long_cyclic, Variable{"diff_long_cyclic", K::blade_pitch, lat});
    visit(s.elevator, Variable{"elevator", K::surface, lon});
    visit(s.aileron, Variable{"aileron", K::surface, lat});
    visit(s.rudder, Variable{"rudder", K::surface, lat});
    visit(s.lateral_cyclic, Variable{"lateral_cyclic", K::blade_pitch, lon});
    visit(s.gust.x, Variable{"gust_u", K::gust, lon});
    visit(s.gust.y, Variable{"gust_v", K::gust, lat});
    visit(s.gust.z, Variable{"gust_w", K::gust, lon});
  }

  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    describe(s, [&visit](auto& x, const Variable&) { visit(x); });
  }
};

inline constexpr int control_count = count_variables<Controls>();
static_assert(sizeof(Controls<int>) == control_count * sizeof(int), "every member of Controls is described");

// Place of each input: kControlIndex.pedal, kControlIndex.gust.x.
inline constexpr Controls<int> kControlIndex = places<Controls>();
inline constexpr auto kControlVariables = variable_table<Controls>();
static_assert(is_complete(kControlVariables), "names are unlike");

// What the blades and surfaces see.
template <class T>
struct BladeControls {
  T collective[2];              // pitch at 0.75 R, right and left, rad
  T long_cyclic[2];             // B1, rad
  T lateral_cyclic[2];          // A1, rad
  T elevator, aileron, rudder;  // rad
};

}  // namespace tiltrotor
