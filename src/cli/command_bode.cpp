// `tiltrotor bode`: frequency responses, poles and zeros, bandwidth and margins of the exact linear model.

#include <cmath>
#include <cstdio>
#include <limits>

#include "cli/channel_model.hpp"
#include "cli/command.hpp"
#include "cli/errors.hpp"
#include "cli/figure.hpp"
#include "cli/flight_records.hpp"
#include "cli/governed.hpp"
#include "cli/linear_options.hpp"
#include "cli/output.hpp"
#include "cli/transfer_of.hpp"

namespace tiltrotor::cli {

namespace {

enum class Show : unsigned char { response, roots, margins };

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = kRadPerDeg<double>;
constexpr Range gain_range{-1e9, 1e9, "inputs per output"};

double decibel(double gain) { return gain > 0 ? 20 * std::log10(gain) : nothing; }

// Columns of each kind of rows, behind those of the flight and before its status and settings.
std::vector<std::string> columns_of(Show show) {
  std::vector<std::string> columns = {"mast_deg", "speed_mps", "input", "output", "gain_unit"};
  const std::vector<std::string> own[] = {
      {"omega_rad_s", "gain", "gain_db", "phase_deg"},
      {"kind", "real", "imag", "frequency_rad_s", "damping_ratio"},
      {"omega_180_rad_s", "bandwidth_phase_rad_s", "bandwidth_gain_rad_s", "bandwidth_rad_s", "phase_delay_s",
       "loop_gain", "gain_margin_db", "omega_gain_rad_s", "phase_margin_deg", "omega_phase_rad_s",
       "delay_margin_s", "unstable_open", "unstable_closed"}};
  const auto& more = own[static_cast<std::size_t>(show)];
  columns.insert(columns.end(), more.begin(), more.end());
  for (const char* last : {"status", "altitude_m", "mass_kg", "cg_sl_in", "flap_deg"})
    columns.emplace_back(last);
  return columns;
}

class Bode {
 public:
  Bode(const Arguments& arguments, const std::vector<SetupOptions>& setups)
      : show_(static_cast<Show>(arguments.choice("--show", "response", {"response", "roots", "margins"}))),
        model_(arguments, setups.front().switches()),
        frequencies_(frequencies(arguments)),
        loop_gain_(arguments.number("--gain", 1, gain_range)),
        output_(arguments),
        figure_(arguments),
        records_(arguments, setups, output_, columns_of(show_), Output::to_read) {
    gain_.id = "bode_gain";
    gain_.title = "Gain";
    gain_.y.label = "Gain, dB";
    phase_.id = "bode_phase";
    phase_.title = "Phase";
    phase_.y.label = "Phase, deg";
    for (plot::Plot* const p : {&gain_, &phase_}) {
      p->x.label = "Frequency, rad/s";
      p->x.logarithmic = true;
      p->width = 640;
      p->axes_height = 220;
    }
  }

  const Shard& shard() const { return output_.shard(); }

  int add(const TrimmedFlight& flight, Analyses& work) {
    if (!is_trimmed(flight.trim.status)) {
      for (const ChannelChoice& which : model_.choices())
        add_row(flight, which, empty(), trim_status_word(flight.trim.status));
      return exit_case_failed;
    }
    const Status status = model_.find(flight, work);
    int exit_status = exit_success;
    for (const ChannelChoice& which : model_.choices()) {
      Status found = status == Status::ok ? model_.find_channel(which, transfer_) : status;
      if (found == Status::ok) found = add_channel(flight, which);
      if (found == Status::ok) continue;
      add_row(flight, which, empty(), status_word(found));
      std::fprintf(stderr, "tiltrotor: %s, %s: %s\n", flight.where.c_str(), which.name().c_str(),
                   status_text(found));
      exit_status = exit_case_failed;
    }
    return exit_status;
  }

  void finish() {
    records_.finish();
    figure_.draw("Frequency responses of the exact linear model", {gain_, phase_});
  }

 private:
  Row empty() const {
    Row row;
    const std::size_t own = columns_of(show_).size() - columns_of(Show::response).size() + 4;
    for (std::size_t k = 0; k < own; ++k) row.emplace_back(nothing);
    if (show_ == Show::roots) row.front() = std::string();
    return row;
  }

  void add_row(const TrimmedFlight& flight, const ChannelChoice& which, const Row& own, const char* status) {
    Row row = {as_given(flight.mast_deg), as_given(flight.flight.speed), vehicle_input(which.input).name,
               which.output_name(), which.unit()};
    row.insert(row.end(), own.begin(), own.end());
    row.emplace_back(std::string(status));
    for (const char* setting : {"altitude_m", "mass_kg", "cg_sl_in", "flap_deg"})
      row.emplace_back(as_given(flight.setting(setting)));
    records_.add(flight, row);
  }

  Status add_channel(const TrimmedFlight& flight, const ChannelChoice& which) {
    const char* const status =
        transfer_.transfer().gain == 0 ? "no_response" : trim_status_word(flight.trim.status);
    if (show_ == Show::response || figure_.wanted()) add_response(flight, which, status);
    if (show_ == Show::roots) add_roots(flight, which, status);
    return show_ == Show::margins ? add_margins(flight, which, status) : Status::ok;
  }

  void add_response(const TrimmedFlight& flight, const ChannelChoice& which, const char* status) {
    plot::Series gains, phases;
    gains.name = which.name() + ", mast " + number_text(flight.mast_deg, 4) + ", " +
                 number_text(flight.flight.speed, 4) + " m/s";
    gains.color = plot::kLineColor[gain_.series.size() % plot::kLineColors];
    for (const double omega : frequencies_) {
      const std::complex<double> value = transfer_.at({0, omega});
      const double gain = std::abs(value);
      const bool there = std::isfinite(gain) && gain > 0;
      const double phase = there ? transfer_.phase(omega, value) / degree : nothing;
      if (show_ == Show::response) add_row(flight, which, {omega, gain, decibel(gain), phase}, status);
      gains.x.push_back(omega);
      gains.y.push_back(decibel(gain));
      phases.y.push_back(phase);
    }
    phases.name = gains.name;
    phases.color = gains.color;
    phases.x = gains.x;
    if (!figure_.wanted()) return;
    gain_.series.push_back(gains);
    phase_.series.push_back(phases);
  }

  void add_roots(const TrimmedFlight& flight, const ChannelChoice& which, const char* status) {
    const VehicleTransfer<double>& f = transfer_.transfer();
    const auto add = [&](const char* kind, double real, double imag) {
      const double size = std::hypot(real, imag);
      add_row(flight, which, {kind, real, imag, size, size > 0 ? -real / size : 0}, status);
    };
    const auto add_all = [&](const char* kind, const Eigenvalues<double, kMaxVehicleStates>& roots) {
      for (int k = 0; k < roots.size; ++k) add(kind, roots.real[k], roots.imag[k]);
    };
    add_all("pole", f.poles);
    add_all("zero", f.zeros);
    add_row(flight, which, {"gain", f.gain, nothing, nothing, nothing}, status);
    add_row(flight, which, {"steady_gain", transfer_.at({0, 0}).real(), nothing, nothing, nothing}, status);
  }

  Status add_margins(const TrimmedFlight& flight, const ChannelChoice& which, const char* status) {
    const Bandwidth<double> b = transfer_.find_bandwidth();
    Margins<double> m;
    const Status found = transfer_.find_margins(loop_gain_, m);
    if (found != Status::ok) return found;
    add_row(flight, which,
            {b.omega_180, b.by_phase, b.by_gain, b.rate_command, b.phase_delay, loop_gain_, decibel(m.gain),
             m.omega_gain, m.phase / degree, m.omega_phase, m.delay, static_cast<double>(m.unstable_open),
             static_cast<double>(m.unstable_closed)},
            status);
    return Status::ok;
  }

  Show show_;
  ChannelModel model_;
  std::vector<double> frequencies_;
  double loop_gain_;
  Output output_;  // last of what arguments can refuse
  Figure figure_;
  FlightRecords records_;
  plot::Plot gain_, phase_;
  TransferOf transfer_;
};

int run(const Arguments& arguments) {
  const std::vector<SetupOptions> setups = SetupOptions::every_combination(arguments);
  require_no_positions(setups.front().switches(), arguments);
  flight_cases(arguments, setups.size());
  if (arguments.given("--gain") && arguments.text("--show", "response") != "margins")
    throw UsageError(arguments.where("--gain") + ": goes with --show margins");
  Bode bode(arguments, setups);
  const AnalysesWorkspace work;
  const int exit_status =
      for_each_trim(arguments, setups, bode.shard(), *work,
                    [&](const TrimmedFlight& flight) -> int { return bode.add(flight, *work); });
  bode.finish();
  return exit_status;
}

}  // namespace

Command bode_command() {
  return {
      "bode",
      "frequency responses, poles, zeros, bandwidth and margins",
      "From the exact A, B, C and D at trim, rotors and wash included; of what the input reaches and the output sees.\n"
      "Outputs are states, the heading psi, instruments, load factors at stations and loads of components, as with\n"
      "linearize --outputs. psi is the integral of psi' = (q sin phi + r cos phi)/cos theta.\n"
      "--show response: gain, in the unit of `gain_unit`, and phase, continuous over frequency.\n"
      "--show roots: poles, transmission zeros, the gain k of k prod(s - zero)/prod(s - pole), and that at s = 0.\n"
      "--show margins: of an attitude the bandwidth by phase and by gain, the smaller of both (rate response\n"
      "types, empty where one is; by phase alone for attitude response types) and the phase delay, ADS-33E-PRF\n"
      "3.3.2.1, the input taken with the sign to which the attitude follows; of the loop input = -K output the\n"
      "margins nearest to instability, of a stable one the shortest delay that ends it, and the unstable roots\n"
      "without and with it. Crossings are looked for in 0.01..1000 rad/s.\n"
      "With --feedback the inputs are what the pilot adds to the law.\n"
      "A status of no_response: the input does not act on the output.\n"
      "Everything that describes the flight takes a value, a list or a range; so do --altitude, --mass, --cg-sl,\n"
      "--flap, --rotor-rpm and --isa-offset.\n",
      "tiltrotor bode --mast 90 --speed 100 --from elevator --to theta,q --show margins",
      channel_options() +
          OptionList{frequency_option(),
                     {"--show", "KIND", "response, roots or margins (response)"},
                     {"--gain", "K", "of the loop, in the unit of the input over that of the output (1)"}} +
          scas_option() + feedback_option() + figure_option("Bode plot as SVG") + flight_list() +
          SetupOptions::list() + Output::list(),
      run};
}

}  // namespace tiltrotor::cli
