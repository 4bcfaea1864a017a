// The linear model at the present state of an aircraft of the C interface.
#pragma once

#include <cstddef>
#include <cstdint>

#include "library/c_memory.hpp"

namespace tiltrotor::c_interface {

// Of a tr_columns; nullptr for an unknown choice.
const ControlSet* control_set(std::int32_t columns);

// A shape that tr_linearize can have made: the model is then safe to work on.
bool plausible(const tr_linear_shape& shape);

// The arrays of a caller for A and B.
struct LinearArrays {
  R* a;
  std::size_t a_length;
  R* b;
  std::size_t b_length;
};

// Meaning of rows and columns, and whether A and, where it is wanted, B find room.
void put_shape(int states, const int* state, int controls, const int* control, tr_linear_shape& shape);
tr_status check_arrays(int states, int controls, const LinearArrays& to);

// A and B into the arrays, and the rates at the state.
tr_status linearize_here(const Sim& s, tr_work* work, std::int32_t columns, tr_linear_shape* shape,
                         const LinearArrays& to, R* xdot);

}  // namespace tiltrotor::c_interface
