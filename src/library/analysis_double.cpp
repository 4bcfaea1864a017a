#define TILTROTOR_DEFINES_ANALYSIS
#include "tiltrotor/analysis/instances.hpp"

namespace tiltrotor {

TILTROTOR_ANALYSIS(, double, DefaultDifferentiation)
template void evaluate(const Configuration<double>&, const State<double>&, const Controls<double>&,
                       Evaluation<double>&, double);
template void derivative(const Configuration<double>&, const State<double>&, const Controls<double>&, State<double>&,
                         double);

}  // namespace tiltrotor
