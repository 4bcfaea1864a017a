// Second derivatives of the model, for the program and the tests: the one place where it is compiled on nested dual
// numbers.
#undef TILTROTOR_EXTERN_INSTANCES
#include "tiltrotor/analysis/linear/model_motion.hpp"

namespace tiltrotor {

template Status model_motion(const Configuration<double>&, const State<double>&, const Controls<double>&,
                             const LinearPoint<double>&, ConfigurationParameter, const TrimMotion<double>&,
                             ModelMotionWorkspace<double>&, ModelMotion<double>&);

}  // namespace tiltrotor
