// Calls of the standard for what this FMU does not have: other types, clocks, configuration mode.
#include "fmu/instance.hpp"

using namespace tiltrotor_fmu;

namespace {

// No reference is of the type: right for none at all, else an error.
fmi3Status absent(fmi3Instance instance, size_t references, const char* what) {
  Instance* const i = opened(instance, kAlive, what);
  if (i == nullptr) return fmi3Error;
  return references == 0 ? fmi3OK : say(*i, fmi3Error, "no variable of this FMU is %s", what);
}
fmi3Status refused(fmi3Instance instance, const char* call) {
  Instance* const i = opened(instance, kAlive, call);
  return i == nullptr ? fmi3Error : say(*i, fmi3Error, "%s: this FMU has no use for it", call);
}

}  // namespace

#define REFERENCES fmi3Instance instance, const fmi3ValueReference[], size_t references
#define ABSENT(type)                                                                                         \
  fmi3Status fmi3Get##type(REFERENCES, fmi3##type[], size_t) { return absent(instance, references, #type); } \
  fmi3Status fmi3Set##type(REFERENCES, const fmi3##type[], size_t) {                                         \
    return absent(instance, references, #type);                                                              \
  }
ABSENT(Float32)
ABSENT(Int8)
ABSENT(UInt8)
ABSENT(Int16)
ABSENT(UInt16)
ABSENT(Int32)
ABSENT(UInt64)
ABSENT(String)

fmi3Status fmi3GetBinary(REFERENCES, size_t[], fmi3Binary[], size_t) {
  return absent(instance, references, "Binary");
}
fmi3Status fmi3SetBinary(REFERENCES, const size_t[], const fmi3Binary[], size_t) {
  return absent(instance, references, "Binary");
}
fmi3Status fmi3GetClock(REFERENCES, fmi3Clock[]) { return absent(instance, references, "Clock"); }
fmi3Status fmi3SetClock(REFERENCES, const fmi3Clock[]) { return absent(instance, references, "Clock"); }
fmi3Status fmi3GetIntervalDecimal(REFERENCES, fmi3Float64[], fmi3IntervalQualifier[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3GetIntervalFraction(REFERENCES, fmi3UInt64[], fmi3UInt64[], fmi3IntervalQualifier[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3SetIntervalDecimal(REFERENCES, const fmi3Float64[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3SetIntervalFraction(REFERENCES, const fmi3UInt64[], const fmi3UInt64[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3GetShiftDecimal(REFERENCES, fmi3Float64[]) { return absent(instance, references, "Clock"); }
fmi3Status fmi3GetShiftFraction(REFERENCES, fmi3UInt64[], fmi3UInt64[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3SetShiftDecimal(REFERENCES, const fmi3Float64[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3SetShiftFraction(REFERENCES, const fmi3UInt64[], const fmi3UInt64[]) {
  return absent(instance, references, "Clock");
}
fmi3Status fmi3GetOutputDerivatives(REFERENCES, const fmi3Int32[], fmi3Float64[], size_t) {
  return absent(instance, references, "an output with derivatives in time");
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) {
  return refused(instance, "fmi3EnterConfigurationMode");
}
fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) {
  return refused(instance, "fmi3ExitConfigurationMode");
}
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) {
  return refused(instance, "fmi3EvaluateDiscreteStates");
}
fmi3Status fmi3EnterStepMode(fmi3Instance instance) { return refused(instance, "fmi3EnterStepMode"); }
fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference, fmi3Float64) {
  return refused(instance, "fmi3ActivateModelPartition");
}
