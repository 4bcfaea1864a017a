// A small importer: loads the FMU that the build has made, keeps its log, integrates.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "check.hpp"
#include "fmu/fmi3.h"
#include "fmu/variables.hpp"

namespace fmu {

using Reference = fmi3ValueReference;
using tiltrotor_fmu::kContinuousStates;
using tiltrotor_fmu::reference_of;
using tiltrotor_fmu::Role;

inline Reference state(int k) { return reference_of(Role::state, k); }
inline Reference rate(int k) { return reference_of(Role::rate, k); }
inline Reference input(int k) { return reference_of(Role::input, k); }
inline Reference output(int k) { return reference_of(Role::output, k); }
inline Reference setting(int k) { return reference_of(Role::setting, k); }

/// The binary; empty when the build has none (single precision).
inline std::string binary_path() {
  const std::filesystem::path folder = std::string(TILTROTOR_BINARY_DIR) + "/fmu/binaries";
  if (!std::filesystem::exists(folder)) return "";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    return (entry.path() / "tiltrotor.so").string();
  return "";
}

inline void* library() {
  static void* const handle = dlopen(binary_path().c_str(), RTLD_NOW | RTLD_LOCAL);
  return handle;
}

template <class Function>
Function* found(Function*, const char* name) {
  void* const address = library() == nullptr ? nullptr : dlsym(library(), name);
  if (!CHECK(address != nullptr)) NOTE(name << " is missing in " << binary_path());
  return reinterpret_cast<Function*>(address);
}
/// A function of the binary, by the name the standard gives it: FMI(fmi3DoStep)(instance, ...).
#define FMI(name) (*fmu::found(static_cast<decltype(&name)>(nullptr), #name))

inline std::string description() {
  std::ifstream in(std::string(TILTROTOR_BINARY_DIR) + "/fmu/modelDescription.xml", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Of the first such attribute after `from`.
inline std::string attribute(const std::string& text, const std::string& name, std::size_t from = 0) {
  const std::size_t at = text.find(" " + name + "=\"", from);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + name.size() + 3;
  return text.substr(begin, text.find('"', begin) - begin);
}

inline void keep_message(fmi3InstanceEnvironment log, fmi3Status, fmi3String, fmi3String message) {
  static_cast<std::vector<std::string>*>(log)->push_back(message);
}

/// One instance, with what it said.
class Master {
 public:
  enum Kind { model_exchange, co_simulation };

  explicit Master(Kind kind) : kind_(kind) {
    const std::string token = attribute(description(), "instantiationToken");
    instance =
        kind == model_exchange
            ? FMI(fmi3InstantiateModelExchange)("one", token.c_str(), "", false, true, &log, keep_message)
            : FMI(fmi3InstantiateCoSimulation)("one", token.c_str(), "", false, true, false, false, nullptr,
                                               0, &log, keep_message, nullptr);
    CHECK(instance != nullptr);
  }
  Master(const Master&) = delete;
  Master& operator=(const Master&) = delete;
  ~Master() { FMI(fmi3FreeInstance)(instance); }

  fmi3Status set(Reference at, double value) const {
    return FMI(fmi3SetFloat64)(instance, &at, 1, &value, 1);
  }
  fmi3Status set_switch(int at, bool on) const {
    const Reference reference = setting(at);
    return FMI(fmi3SetBoolean)(instance, &reference, 1, &on, 1);
  }
  double get(Reference at) const {
    double value = 0;
    CHECK_EQ(FMI(fmi3GetFloat64)(instance, &at, 1, &value, 1), fmi3OK);
    return value;
  }

  /// Through initialization, into the mode in which it flies; the worst status on the way.
  fmi3Status start(double mast_deg, double speed) {
    CHECK_EQ(set(setting(tiltrotor_fmu::kMast), mast_deg * tiltrotor_fmu::kRadians), fmi3OK);
    CHECK_EQ(set(setting(tiltrotor_fmu::kTrimSpeed), speed), fmi3OK);
    CHECK_EQ(FMI(fmi3EnterInitializationMode)(instance, false, 0, 0, false, 0), fmi3OK);
    const fmi3Status status = FMI(fmi3ExitInitializationMode)(instance);
    if (kind_ == model_exchange && status <= fmi3Warning)
      CHECK_EQ(FMI(fmi3EnterContinuousTimeMode)(instance), fmi3OK);
    return status;
  }

  std::vector<double> states() const {
    std::vector<double> x(kContinuousStates);
    CHECK_EQ(FMI(fmi3GetContinuousStates)(instance, x.data(), x.size()), fmi3OK);
    return x;
  }
  std::vector<double> rates(const std::vector<double>& x) const {
    std::vector<double> xdot(x.size());
    CHECK_EQ(FMI(fmi3SetContinuousStates)(instance, x.data(), x.size()), fmi3OK);
    CHECK_EQ(FMI(fmi3GetContinuousStateDerivatives)(instance, xdot.data(), xdot.size()), fmi3OK);
    return xdot;
  }

  /// Kutta's method of order 3, or the classical one of order 4.
  void integrate(double dt, int order) const {
    const std::vector<double> x = states();
    const auto moved = [&x](double by, const std::vector<double>& a, double also = 0,
                            const std::vector<double>& b = {}) {
      std::vector<double> y = x;
      for (std::size_t k = 0; k < y.size(); ++k) y[k] += by * a[k] + (b.empty() ? 0 : also * b[k]);
      return y;
    };
    const std::vector<double> k1 = rates(x);
    const std::vector<double> k2 = rates(moved(dt / 2, k1));
    std::vector<double> sum = k1;
    if (order == 3) {
      const std::vector<double> k3 = rates(moved(-dt, k1, 2 * dt, k2));
      for (std::size_t k = 0; k < x.size(); ++k) sum[k] += 4 * k2[k] + k3[k];
    } else {
      const std::vector<double> k3 = rates(moved(dt / 2, k2));
      const std::vector<double> k4 = rates(moved(dt, k3));
      for (std::size_t k = 0; k < x.size(); ++k) sum[k] += 2 * k2[k] + 2 * k3[k] + k4[k];
    }
    const std::vector<double> next = moved(dt / 6, sum);
    CHECK_EQ(FMI(fmi3SetContinuousStates)(instance, next.data(), next.size()), fmi3OK);
    bool event = true, terminate = true;
    CHECK_EQ(FMI(fmi3CompletedIntegratorStep)(instance, true, &event, &terminate), fmi3OK);
    CHECK(!event && !terminate);
  }

  fmi3Status step(double time, double dt) const {
    bool event = true, terminate = true, early = true;
    double reached = -1;
    const fmi3Status status = FMI(fmi3DoStep)(instance, time, dt, true, &event, &terminate, &early, &reached);
    if (status == fmi3OK) CHECK(!event && !terminate && !early && reached == time + dt);
    return status;
  }

  fmi3Instance instance;
  mutable std::vector<std::string> log;

 private:
  Kind kind_;
};

}  // namespace fmu
