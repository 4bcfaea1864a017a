// The isolated rotor as an entry point of the stack budget: a template that no library holds.
#include "tiltrotor/analysis/isolated_rotor.hpp"

using namespace tiltrotor;

extern "C" int tr_isolated_rotor(const Configuration<double>& c, const RotorFlow<double>& flow,
                                 IsolatedRotorWorkspace<double>& work, IsolatedRotor<double>& rotor) {
  return static_cast<int>(isolated_rotor(c, flow, work, rotor));
}
