// Arithmetic other than assumed is found when it is met: the rounding modes of the C library, fesetround(), and
// the modes of the processor that take the smallest numbers for zero.
// Expected: the rounding modes of fenv.h; the control registers of x86 and AArch64.
#include <cfenv>
#include <vector>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "check.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"
#include "tiltrotor/model/preparation.hpp"
#include "tiltrotor/sensors.h"
#include "tiltrotor/tiltrotor.h"

using namespace tiltrotor;

namespace {

class Rounding {
 public:
  explicit Rounding(int mode) : changed_(std::fesetround(mode) == 0) {}
  ~Rounding() { std::fesetround(FE_TONEAREST); }
  bool changed() const { return changed_; }

 private:
  bool changed_;
};

constexpr int kModes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

// Bits of the control register: flush-to-zero, denormals-are-zero.
#ifdef __SSE2__
const std::vector<unsigned> kSmallModes = {0x8000, 0x0040, 0x8040};
unsigned long control() { return _mm_getcsr(); }
void set_control(unsigned long bits) { _mm_setcsr(static_cast<unsigned>(bits)); }
#elif defined(__aarch64__)
const std::vector<unsigned> kSmallModes = {1u << 24};
unsigned long control() {
  unsigned long bits;
  asm volatile("mrs %0, fpcr" : "=r"(bits));
  return bits;
}
void set_control(unsigned long bits) { asm volatile("msr fpcr, %0" : : "r"(bits)); }
#else
const std::vector<unsigned> kSmallModes;
unsigned long control() { return 0; }
void set_control(unsigned long) {}
#endif

class SmallNumbersAreZero {
 public:
  explicit SmallNumbersAreZero(unsigned bits) : before_(control()) { set_control(before_ | bits); }
  ~SmallNumbersAreZero() { set_control(before_); }

 private:
  unsigned long before_;
};

}  // namespace

TEST(arithmetic_to_nearest_is_accepted) {
  CHECK(is_ieee_arithmetic<double>());
  CHECK(is_ieee_arithmetic<float>());
}

TEST(arithmetic_other_rounding_is_found_by_prepare) {
  static Configuration<double> c;
  static Configuration<float> f;
  const FlightSetup<double> setup = flight_setup(aircraft_data<double>(), 30.0);
  const FlightSetup<float> setup_float = flight_setup(aircraft_data<float>(), 30.0f);
  for (const int mode : kModes) {
    Status status, status_float;
    {
      const Rounding rounding(mode);
      if (!rounding.changed()) continue;
      status = prepare(aircraft_data<double>(), setup, c);
      status_float = prepare(aircraft_data<float>(), setup_float, f);
    }
    CHECK(status == Status::bad_arithmetic);
    CHECK(status_float == Status::bad_arithmetic);
  }
  CHECK(prepare(aircraft_data<double>(), setup, c) == Status::ok);
}

TEST(arithmetic_other_rounding_is_found_by_every_call_that_computes) {
  static tr_sim sim, other;
  static tr_work work;
  tr_setup setup;
  tr_flight flight{};
  flight.speed_mps = 40;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0), TR_OK);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  CHECK_EQ(tr_trim(&sim, &work, &flight, nullptr), TR_OK);
  const tr_real one[1] = {1};
  tr_real real[1], imag[1], rates[TR_STATES];
  tr_linear_shape shape;
  tr_outputs outputs;
  tr_motion motion;
  tr_air_data air;
  const tr_real station[3] = {7, 0, 2};
  const double position[3] = {1, 2, 3};
  tr_geodetic place = {};
  tr_lag lag = {};
  tr_imu imu = {};
  tr_air_probe probe = {};
  std::uint32_t bits;
  for (const int mode : kModes) {
    tr_status found[18];
    {
      const Rounding rounding(mode);
      if (!rounding.changed()) continue;
      found[0] = tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0);
      found[1] = tr_init(&other, TR_API_VERSION, &setup);
      found[2] = tr_trim(&sim, &work, &flight, nullptr);
      found[3] = tr_step(&sim, &work, static_cast<tr_real>(0.005));
      found[4] = tr_derivative(&sim, rates, TR_STATES);
      found[5] = tr_linearize(&sim, &work, TR_INCEPTORS, &shape, nullptr, 0, nullptr, 0);
      found[6] = tr_get_outputs(&sim, &outputs);
      found[7] = tr_eigenvalues(&work, one, 1, real, imag, 1);
      found[8] = tr_step_with_outputs(&sim, &work, static_cast<tr_real>(0.005), &outputs);
      found[9] = tr_get_flags(&sim, &bits);
      found[10] = tr_motion_at(&sim, station, &motion);
      found[11] = tr_air_data_at(&sim, station, &air);
      found[12] = tr_directional(&sim, &work, rates, rates, rates, &outputs);
      found[13] = tr_geodetic_at(&place, position, &place);
      found[14] = tr_radio_height_at(&sim, station, real);
      found[15] = tr_step_lag(&lag, 1, static_cast<tr_real>(0.005));
      found[16] = tr_read_imu(&sim, &imu, static_cast<tr_real>(0.005));
      found[17] = tr_read_air_probe(&sim, &probe, static_cast<tr_real>(0.005), &air);
    }
    for (const tr_status status : found) CHECK_EQ(status, TR_BAD_ARITHMETIC);
  }
  CHECK_EQ(tr_step(&sim, &work, static_cast<tr_real>(0.005)), TR_OK);
}

TEST(arithmetic_that_loses_small_numbers_is_found) {
  static Configuration<double> c;
  static Configuration<float> f;
  static tr_sim sim;
  static tr_work work;
  tr_setup setup;
  tr_flight flight{};
  flight.speed_mps = 40;
  CHECK_EQ(tr_default_setup(&setup, TR_API_VERSION, tr_aircraft_at(0), 0), TR_OK);
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
  CHECK_EQ(tr_trim(&sim, &work, &flight, nullptr), TR_OK);
  const FlightSetup<double> wanted = flight_setup(aircraft_data<double>(), 30.0);
  const FlightSetup<float> wanted_float = flight_setup(aircraft_data<float>(), 30.0f);
  for (const unsigned bits : kSmallModes) {
    Status status, status_float;
    tr_status step, trimmed, initialised;
    {
      const SmallNumbersAreZero mode(bits);
      status = prepare(aircraft_data<double>(), wanted, c);
      status_float = prepare(aircraft_data<float>(), wanted_float, f);
      step = tr_step(&sim, &work, static_cast<tr_real>(0.005));
      trimmed = tr_trim(&sim, &work, &flight, nullptr);
      initialised = tr_init(&sim, TR_API_VERSION, &setup);
    }
    CHECK(status == Status::bad_arithmetic);
    CHECK(status_float == Status::bad_arithmetic);
    CHECK_EQ(step, TR_BAD_ARITHMETIC);
    CHECK_EQ(trimmed, TR_BAD_ARITHMETIC);
    CHECK_EQ(initialised, TR_BAD_ARITHMETIC);
  }
  CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OK);
}
