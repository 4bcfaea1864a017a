// The way into what explains a refusal, as c_entry.cpp: a program that does not ask links none of it.
#include "library/c_entry.hpp"
#include "tiltrotor/conditions.h"
#include "tiltrotor/systems.h"

namespace tiltrotor::c_interface::checked {

decltype(::tr_check_systems) tr_check_systems;
decltype(::tr_check_environment) tr_check_environment;
decltype(::tr_check_configuration) tr_check_configuration;
decltype(::tr_get_range) tr_get_range;

}  // namespace tiltrotor::c_interface::checked

using namespace tiltrotor::c_interface;

namespace {

tr_status processor_status() {
  return entry_status(tiltrotor::compiled_instructions, tiltrotor::processor_instructions());
}

}  // namespace

tr_status tr_check_systems(const tr_systems* systems, uint32_t version, char* text, size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_check_systems(systems, version, text, length) : status;
}

tr_status tr_check_environment(const tr_environment* environment, uint32_t version, char* text,
                               size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_check_environment(environment, version, text, length) : status;
}

tr_status tr_check_configuration(const tr_configuration* configuration, uint32_t version, char* text,
                                 size_t length) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_check_configuration(configuration, version, text, length) : status;
}

tr_status tr_get_range(const char* name, tr_real* low, tr_real* high) {
  const tr_status status = processor_status();
  return status == TR_OK ? checked::tr_get_range(name, low, high) : status;
}
