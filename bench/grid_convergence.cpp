// Convergence of the blade grid: how far thrust, torque, trim and the rigid-body eigenvalues of a grid stand
// from those of a fine one, over the trim set, for mid-point and Gauss-Legendre stations. Writes
// grid_convergence.csv to the directory given, build/bench by default.
//
// Thrust and torque: at the state trimmed on the fine grid, over half the weight and over the fine value.
// Trim: largest change of pitch attitude and collective. Eigenvalues: of the rigid-body model with
// quasi-steady rotors, each against the closest one, over its size or kSlow, whichever is larger (a slower
// mode has no meaning in flight, and a zero has no percentage).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "tiltrotor/analysis/instances.hpp"
#include "tiltrotor/math/algebra/eigen.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace {

using namespace tiltrotor;

constexpr double kSlow = 0.05;  // rad/s

struct MastSpeeds {
  double mast_deg, first, last, step;
};
constexpr MastSpeeds kTrimSet[] = {{0, 0, 50, 5},    {15, 0, 60, 10},   {30, 10, 60, 10}, {45, 20, 70, 10},
                                   {60, 40, 80, 10}, {75, 50, 100, 10}, {90, 70, 130, 10}};
constexpr Quadrature kFine = {RadialRule::midpoint, {12, 24, 20, 16, 4, 4}, 48};

constexpr Quadrature kCandidates[] = {
    kSpecificationQuadrature,
    kRealtimeQuadrature,
    {RadialRule::midpoint, {0, 9, 5, 4, 1, 1}, 48},
    {RadialRule::midpoint, {0, 9, 5, 4, 1, 1}, 16},
    {RadialRule::midpoint, {0, 9, 5, 4, 1, 1}, 12},
    {RadialRule::midpoint, {0, 9, 5, 4, 1, 1}, 8},
    {RadialRule::midpoint, {0, 18, 10, 8, 2, 2}, 24},
    {RadialRule::midpoint, {0, 18, 10, 8, 2, 2}, 48},
    {RadialRule::midpoint, {3, 4, 4, 3, 1, 1}, 8},
    {RadialRule::midpoint, {0, 5, 3, 2, 1, 1}, 8},
    {RadialRule::gauss, {5, 5, 5, 5, 2, 2}, 48},
    {RadialRule::gauss, {5, 5, 5, 5, 2, 2}, 24},
    {RadialRule::gauss, {3, 4, 4, 3, 1, 1}, 48},
    {RadialRule::gauss, {3, 4, 4, 3, 1, 1}, 24},
    {RadialRule::gauss, {3, 4, 4, 3, 1, 1}, 16},
    {RadialRule::gauss, {3, 4, 4, 3, 1, 1}, 12},
    {RadialRule::gauss, {3, 4, 4, 3, 1, 1}, 6},
    {RadialRule::gauss, {3, 4, 3, 3, 1, 1}, 8},
    {RadialRule::gauss, {2, 4, 4, 3, 1, 1}, 8},
    {RadialRule::gauss, {2, 3, 3, 3, 1, 1}, 16},
    {RadialRule::gauss, {2, 3, 3, 3, 1, 1}, 8},
    {RadialRule::gauss, {0, 5, 3, 3, 1, 1}, 8},
    {RadialRule::gauss, {2, 3, 2, 2, 1, 1}, 8},
    {RadialRule::gauss, {2, 2, 2, 2, 1, 1}, 8},
    {RadialRule::gauss, {1, 2, 2, 2, 1, 1}, 8},
};

struct Workspace {
  TrimWorkspace<double> trim;
  LinearizationWorkspace<double> linearization;
  ResidualisationWorkspace<double> residualisation;
  EigenWorkspace<double, kMaxLinearStates> eigen;
  LinearModel<double> full, reduced;
  Evaluation<double> evaluation;
};

struct Spectrum {
  bool ok = false;
  double real[kRigidStates] = {};
  double imag[kRigidStates] = {};
};

struct Flight {
  double mast_deg, speed;
  TrimResult<double> trim;  // on the fine grid
  double thrust[2], torque[2];
  Spectrum spectrum;
};

Configuration<double> configuration(double mast_deg, const Quadrature& q) {
  const Aircraft<double>& aircraft = aircraft_data<double>();
  Configuration<double> c;
  (void)prepare(aircraft, flight_setup(aircraft, mast_deg), c);
  c.blade = blade_stations(aircraft.rotor, c.setup.options, q, 1);
  c.azimuth = averaged_azimuth<double>(aircraft.rotor.blades, q.azimuth);
  return c;
}

Spectrum rigid_spectrum(const Configuration<double>& c, const TrimResult<double>& at, Workspace& work) {
  Spectrum s;
  if (linearize(c, at.state, at.controls, kInceptors, work.linearization, work.full) != Status::ok) return s;
  if (residualise(work.full, work.residualisation, work.reduced) != Status::ok) return s;
  Eigenvalues<double, kMaxLinearStates> values;
  if (eigenvalues(work.reduced.a, kRigidStates, work.eigen, values) != Status::ok) return s;
  std::copy(values.real, values.real + kRigidStates, s.real);
  std::copy(values.imag, values.imag + kRigidStates, s.imag);
  s.ok = true;
  return s;
}

// Largest distance of an eigenvalue from the closest one of the fine grid.
double distance(const Spectrum& fine, const Spectrum& other) {
  double worst = 0;
  for (int i = 0; i < kRigidStates; ++i) {
    double nearest = 1e30;
    for (int j = 0; j < kRigidStates; ++j)
      nearest = std::min(nearest, std::hypot(fine.real[i] - other.real[j], fine.imag[i] - other.imag[j]));
    worst = std::max(worst, nearest / std::max(std::hypot(fine.real[i], fine.imag[i]), kSlow));
  }
  return worst;
}

void rotor_sums(const Configuration<double>& c, const TrimResult<double>& at, Workspace& work, double* thrust,
                double* torque) {
  evaluate_aircraft(c, at.state, at.controls, work.evaluation);
  for (int side = 0; side < 2; ++side) {
    thrust[side] = work.evaluation.rotor[side].loads.force_a.z;
    torque[side] = work.evaluation.rotor[side].loads.torque;
  }
}

struct Errors {
  double thrust = 0, torque = 0, eigenvalue = 0;  // fractions
  std::vector<double> each_eigenvalue;            // worst of each flight
  double pitch = 0, collective = 0;               // deg
  double mast_deg = 0, speed = 0;                 // of the worst eigenvalue
  int lost = 0;                                   // flights that no longer trim
};

Errors errors(const Quadrature& q, const std::vector<Flight>& flights, Workspace& work) {
  Errors e;
  for (const Flight& flight : flights) {
    const Configuration<double> c = configuration(flight.mast_deg, q);
    const double half_weight = c.setup.mass * kGravity<double> / 2;
    double thrust[2];
    double torque[2];
    rotor_sums(c, flight.trim, work, thrust, torque);
    for (int side = 0; side < 2; ++side) {
      e.thrust = std::max(e.thrust, std::fabs(thrust[side] - flight.thrust[side]) / half_weight);
      e.torque = std::max(e.torque, std::fabs(torque[side] / flight.torque[side] - 1));
    }
    TrimResult<double> trim = flight.trim;
    SteadyFlight<double> steady{};
    steady.speed = flight.speed;
    if (!is_trimmed(trim_from(c, steady, work.trim, trim))) {
      ++e.lost;
      continue;
    }
    e.pitch = std::max(e.pitch, std::fabs(trim.state.pitch - flight.trim.state.pitch) * kDegPerRad<double>);
    e.collective = std::max(
        e.collective, std::fabs(trim.collective_root - flight.trim.collective_root) * kDegPerRad<double>);
    const Spectrum s = rigid_spectrum(c, trim, work);
    const double d = s.ok ? distance(flight.spectrum, s) : 1;
    e.each_eigenvalue.push_back(d);
    if (d > e.eigenvalue) {
      e.eigenvalue = d;
      e.mast_deg = flight.mast_deg;
      e.speed = flight.speed;
    }
  }
  return e;
}

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double one : x) sum += one;
  return sum / static_cast<double>(x.size());
}
// Nine of ten are smaller.
double ninth_decile(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() * 9 / 10];
}

std::vector<Flight> fine_flights(Workspace& work) {
  std::vector<Flight> flights;
  for (const MastSpeeds& set : kTrimSet) {
    const Configuration<double> c = configuration(set.mast_deg, kFine);
    for (double speed = set.first; speed <= set.last; speed += set.step) {
      Flight flight{set.mast_deg, speed, {}, {}, {}, {}};
      SteadyFlight<double> steady{};
      steady.speed = speed;
      if (!is_trimmed(trim(c, steady, work.trim, flight.trim))) continue;
      rotor_sums(c, flight.trim, work, flight.thrust, flight.torque);
      flight.spectrum = rigid_spectrum(c, flight.trim, work);
      if (flight.spectrum.ok) flights.push_back(flight);
    }
  }
  return flights;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string directory = argc > 1 ? argv[1] : "build/bench";
  const auto work = std::make_unique<Workspace>();
  const std::vector<Flight> flights = fine_flights(*work);
  std::filesystem::create_directories(directory);
  std::ofstream csv(directory + "/grid_convergence.csv");
  csv << "rule,radial,azimuth,elements,thrust_error_percent,torque_error_percent,trim_pitch_error_deg,"
         "trim_collective_error_deg,eigenvalue_error_mean_percent,eigenvalue_error_ninth_decile_percent,"
         "eigenvalue_error_worst_percent,worst_mast_deg,worst_speed_mps,lost_trims\n";
  std::printf(
      "Blade grid against 80 x 48 stations, %zu trimmed flights: worst errors; eigenvalues mean, 90 %% and "
      "worst\n"
      "stations                     elements  thrust %%  torque %%  pitch deg  coll. deg  eigenvalues %%\n",
      flights.size());
  for (const Quadrature& q : kCandidates) {
    const Errors e = errors(q, flights, *work);
    int radial = 0;
    std::string split;
    for (const int n : q.radial) {
      radial += n;
      if (n > 0) split += (split.empty() ? "" : "+") + std::to_string(n);
    }
    const int elements = 2 * radial * q.azimuth;
    const std::string rule = q.rule == RadialRule::gauss ? "gauss" : "midpoint";
    std::printf("%-8s %-13s x %-2d  %5d  %8.3f  %8.3f  %9.4f  %9.4f  %6.2f %6.2f %6.2f (%g, %g)%s\n",
                rule.c_str(), split.c_str(), q.azimuth, elements, 100 * e.thrust, 100 * e.torque, e.pitch,
                e.collective, 100 * mean(e.each_eigenvalue), 100 * ninth_decile(e.each_eigenvalue),
                100 * e.eigenvalue, e.mast_deg, e.speed, e.lost > 0 ? " some trims lost" : "");
    csv << rule << ',' << split << ',' << q.azimuth << ',' << elements << ',' << 100 * e.thrust << ','
        << 100 * e.torque << ',' << e.pitch << ',' << e.collective << ',' << 100 * mean(e.each_eigenvalue)
        << ',' << 100 * ninth_decile(e.each_eigenvalue) << ',' << 100 * e.eigenvalue << ',' << e.mast_deg
        << ',' << e.speed << ',' << e.lost << '\n';
  }
  return csv ? 0 : 1;
}
