// Roots of the whole vehicle and their names.
// Expected: matrices whose roots are plain, and the rule that rotors come as mean and difference.
#include "tiltrotor/analysis/linear/vehicle_modes.hpp"
#include "vehicle_case.hpp"

using namespace vehicle_case;

namespace {

VehicleModesWorkspace<double> work;
VehicleModes<double> found;

// A rigid body's states that decay at rates of their own, and others beside them.
VehicleShape shape_with(std::initializer_list<int> others) {
  VehicleShape shape{};
  for (const int state : kRigidOrder) shape.state[shape.states++] = state;
  CHECK_EQ(shape.states, kRigidStates);
  for (const int state : others) shape.state[shape.states++] = state;
  set_zero(work.a);
  for (int i = 0; i < shape.states; ++i) work.a(i, i) = -0.1 * (i + 1);
  return shape;
}

bool has_root(double real) {
  for (int k = 0; k < found.count; ++k)
    if (std::fabs(found.mode[k].real - real) < 1e-12 && found.mode[k].imag == 0) return true;
  return false;
}

}  // namespace

TEST(vehicle_modes_refuse_an_order_that_cannot_be) {
  VehicleShape shape = shape_with({});
  for (const int states : {-1, 0, kRigidStates - 1, kMaxVehicleStates + 1}) {
    shape.states = states;
    CHECK(vehicle_modes(shape, work, found) == Status::bad_argument);
    CHECK_EQ(found.count, 0);
  }
  shape.states = kRigidStates;
  work.a(2, 3) = std::numeric_limits<double>::quiet_NaN();
  CHECK(vehicle_modes(shape, work, found) == Status::not_finite);
  CHECK_EQ(found.count, 0);
}

// A rotor's states and those of the other one couple as mean and difference; one without its partner stays itself.
TEST(vehicle_modes_split_rotors_that_are_both_there) {
  const int of_right = kStateIndex.rotor[right].lambda_0, of_left = kStateIndex.rotor[left].lambda_0;
  VehicleShape shape = shape_with({of_right, of_left});
  const int r = kRigidStates, l = r + 1;
  work.a(r, r) = work.a(l, l) = -9;
  work.a(r, l) = work.a(l, r) = 2;  // mean -7, difference -11
  CHECK(vehicle_modes(shape, work, found) == Status::ok);
  CHECK_EQ(found.count, kRigidStates + 2);
  CHECK(has_root(-7) && has_root(-11));

  shape = shape_with({of_right});
  CHECK(vehicle_modes(shape, work, found) == Status::ok);
  CHECK_EQ(found.count, kRigidStates + 1);
  CHECK(has_root(-0.1 * (kRigidStates + 1)));
}

// More than nine roots of one system: ordinals of two digits.
TEST(vehicle_modes_number_many_roots_of_a_system) {
  VehicleShape shape = shape_with({});
  for (int k = 0; k < 12; ++k) shape.state[shape.states++] = state_count + kSystemIndex.power[right];
  for (int i = kRigidStates; i < shape.states; ++i) work.a(i, i) = -1.0 - i;
  CHECK(vehicle_modes(shape, work, found) == Status::ok);
  int last = 0;
  for (int k = 0; k < found.count; ++k) {
    const char* const end = std::strrchr(found.mode[k].name, '_');
    if (end != nullptr && found.mode[k].system_share > 0.9) last = std::max(last, std::atoi(end + 1));
  }
  CHECK_EQ(last, 12);
}
