// The aircraft for C++ programs, in the namespace of the headers. The C interface has it in the library's
// namespace.
#include "library/aircraft_data.cpp"  // NOLINT(bugprone-suspicious-include)
