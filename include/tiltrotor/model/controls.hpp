// Inputs of the aircraft: the pilot's inceptors, direct increments on blades and surfaces, and gusts.
//
// All act together: the increments add to what the gearing makes of the inceptors (control_mixing.hpp). So a
// linear model can have its columns in inceptor inches, in blade angles, or both.
#pragma once

#include "tiltrotor/math/vector.hpp"

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

  static constexpr int kCount = 14;

  template <class Self, class Visit>
  static void each(Self& s, Visit&& visit) {
    visit(s.collective);
    visit(s.long_stick);
    visit(s.lat_stick);
    visit(s.pedal);
    visit(s.long_cyclic);
    visit(s.diff_collective);
    visit(s.diff_long_cyclic);
    visit(s.elevator);
    visit(s.aileron);
    visit(s.rudder);
    visit(s.lateral_cyclic);
    Vec3<T>::each(s.gust, visit);
  }
};

// Places in the order of Controls::each.
enum ControlIndex {
  iu_collective,
  iu_long_stick,
  iu_lat_stick,
  iu_pedal,
  iu_long_cyclic,
  iu_diff_collective,
  iu_diff_long_cyclic,
  iu_elevator,
  iu_aileron,
  iu_rudder,
  iu_lateral_cyclic,
  iu_gust,
  control_count = 14
};

struct ControlName {
  const char* name;
  const char* unit;
};
inline constexpr ControlName kControlNames[control_count] = {
    {"collective", "rad"},  {"long_stick", "in"},       {"lat_stick", "in"},         {"pedal", "in"},
    {"long_cyclic", "rad"}, {"diff_collective", "rad"}, {"diff_long_cyclic", "rad"}, {"elevator", "rad"},
    {"aileron", "rad"},     {"rudder", "rad"},          {"lateral_cyclic", "rad"},   {"gust_u", "m/s"},
    {"gust_v", "m/s"},      {"gust_w", "m/s"}};

// What the blades and surfaces see.
template <class T>
struct BladeControls {
  T collective[2];              // pitch at 0.75 R, right and left, rad
  T long_cyclic[2];             // B1, rad
  T lateral_cyclic[2];          // A1, rad
  T elevator, aileron, rudder;  // rad
};

}  // namespace tiltrotor
