// Frequency responses of the complete linear model against transfer functions identified in flight.

#include <cmath>

#include "plot/plot.hpp"
#include "study/compared_aircraft.hpp"
#include "study/drawn_with.hpp"
#include "study/missing.hpp"
#include "study/reference_points.hpp"
#include "study/sections.hpp"
#include "study/transfer_function.hpp"
#include "study/wording.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr int kPoints = 57;
constexpr double kGainTolerance = 2;    // dB
constexpr double kPhaseTolerance = 15;  // deg

struct Case {
  const char* name;  // of the transfer function
  const char* title;
  double mast_deg, speed_mps, altitude_m;
  int output;
  int input;
  bool derivative;  // the output is the rate of a state
  bool shape_only;  // the gain of the input is not published: both curves meet at 1 rad/s
};
constexpr Case kCases[] = {
    {"cruise_q_elevator", "Pitch rate to elevator, mast 90, 104 m/s, 2438 m", 90, 104.4, 2438,
     kStateIndex.rates.y, kControlIndex.elevator, false, false},
    {"hover_az_power", "Vertical acceleration to power lever, hover", 0, 0, 0, kStateIndex.velocity.z,
     kControlIndex.collective, true, true},
};

Setup setup_of_case(const Case& which, ComparedAircraft aircraft) {
  Setup setup = setup_of(aircraft, which.mast_deg);
  setup.altitude = which.altitude_m;
  return setup;
}

Linear model_of(const Case& which, ComparedAircraft aircraft) {
  return linear_model_at(setup_of_case(which, aircraft), which.speed_mps, kBladeControls);
}

Table frequency_table(const Case& which, const Linear& model, const Linear& other) {
  const Table set = reference_points("transfer_functions").where("name", std::string(which.name));
  const double low = set.number(0, "low_rad_s");
  const double high = set.number(0, "high_rad_s");
  const double delay = set.number(0, "delay_s");
  const auto identified = [&](double omega) {
    const Complex s(0, omega);
    return polynomial(set.text(0, "numerator"), s) / polynomial(set.text(0, "denominator"), s) *
           std::exp(-s * delay);
  };
  const auto response = [&](const Linear& of, double omega) {
    return response_of(of, which.output, which.input, omega, which.derivative);
  };
  const double meeting = 1;  // rad/s
  const auto factor = [&](const Linear& of) {
    return which.shape_only ? std::abs(identified(meeting)) / std::abs(response(of, meeting)) : 1;
  };
  const double here = factor(model);
  const double elsewhere = factor(other);

  Table table({"omega_rad_s", "gain_db", "phase_deg", "identified_gain_db", "identified_phase_deg",
               "other_gain_db", "other_phase_deg"});
  table.comment("other: of the aircraft as simulated.");
  double previous = -180;
  for (int k = 0; k < kPoints; ++k) {
    const double omega = low * std::pow(high / low, k / (kPoints - 1.0));
    const Complex there = identified(omega);
    const Complex value = here * response(model, omega);
    const Complex otherwise = elsewhere * response(other, omega);
    const double phase_there = nearest_turn(phase_deg(there), previous);
    previous = phase_there;
    table.add({omega, decibel(value), nearest_turn(phase_deg(value), phase_there), decibel(there),
               phase_there, decibel(otherwise), nearest_turn(phase_deg(otherwise), phase_there)});
  }
  return table;
}

Picture picture(const Case& which, const Table& table, const char* kind, const char* axis, const char* here,
                const char* there) {
  Plot plot;
  plot.id = std::string("frequency_") + which.name + "_" + kind;
  plot.title = which.title;
  plot.note = drawn_with(compared_aircraft("transfer_functions"),
                         setup_of_case(which, compared_aircraft("transfer_functions")));
  plot.x.label = "Frequency, rad/s";
  plot.x.logarithmic = true;
  plot.x.low = table.number(0, "omega_rad_s");
  plot.x.high = table.number(table.rows() - 1, "omega_rad_s");
  plot.y.label = axis;
  plot.axes_height = 200;
  Series a;
  a.name = "this program";
  a.x = table.numbers("omega_rad_s");
  a.y = table.numbers(here);
  Series b = a;
  b.name = "identified in flight";
  b.color = kOrange;
  b.line = Line::dashed;
  b.y = table.numbers(there);
  plot.series = {a, b};
  return {plot.id, svg(plot)};
}

// Largest differences from a frequency on.
struct Misfit {
  double gain = 0, phase = 0;
};
Misfit misfit(const Table& table, double from) {
  Misfit m;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.number(i, "omega_rad_s") < from) continue;
    m.gain = std::max(m.gain, std::fabs(table.number(i, "gain_db") - table.number(i, "identified_gain_db")));
    m.phase =
        std::max(m.phase, std::fabs(table.number(i, "phase_deg") - table.number(i, "identified_phase_deg")));
  }
  return m;
}

// Pitch acceleration by elevator: in flight, against this aircraft.
std::string elevator_words(const Linear& model) {
  const Table set = reference_points("transfer_functions").where("name", std::string("cruise_q_elevator"));
  const double flown = leading_coefficient(set.text(0, "numerator"));
  const double here = control_derivative(model, kStateIndex.rates.y, kControlIndex.elevator);
  const double less = 100 * (1 - flown / here);
  return " The elevator turns the flown aircraft " + fixed(std::fabs(less), 0) + " % " +
         (less > 0
              ? "less than this one; NASA TM-89428 blames ballast in the tail that the simulated inertia lacks."
              : "more than this one.");
}

Finding judge(const Case& which, const Table& table, const Linear& model) {
  const auto [gain, phase] = misfit(table, 0);
  constexpr double above_phugoid = 1;  // rad/s
  const Misfit fast = misfit(table, above_phugoid);
  const bool good = gain <= kGainTolerance && phase <= kPhaseTolerance;
  return {
      good ? Finding::holds : Finding::partly,
      std::string(which.title) + (which.shape_only ? ", shape" : "") + ": within 2 dB and 15 deg of flight.",
      "Largest differences over the identified band: " + fixed(gain, 1) + " dB, " + fixed(phase, 0) +
          " deg; from 1 rad/s on " + fixed(fast.gain, 1) + " dB, " + fixed(fast.phase, 0) + " deg." +
          (which.shape_only
               ? " The gain of the power lever is not published; both curves meet at 1 rad/s."
               : " The identified form has no phugoid, which bends the model's curve below 1 rad/s." +
                     elevator_words(model))};
}

// NaN when there is none of that kind.
Mode<double> mode_of(const Modes& modes, ModeKind kind) {
  for (int k = 0; k < modes.count; ++k) {
    if (modes.mode[k].label.kind == kind) return modes.mode[k];
  }
  Mode<double> none{};
  none.real = none.frequency = none.damping_ratio = kMissing;
  return none;
}

Finding short_period(const Modes& modes, const Modes& others, Table& compared) {
  const Table identified = reference_points("modes_identified").where("mode", std::string("short period"));
  for (int k = 0; k < modes.count; ++k) {
    const Mode<double>& m = modes.mode[k];
    if (m.label.kind != ModeKind::short_period) continue;
    const double frequency = identified.number(0, "frequency_rad_s");
    const double damping = identified.number(0, "damping_ratio");
    const Mode<double> other = mode_of(others, ModeKind::short_period);
    compared.add({std::string("cruise"), std::string("short_period_frequency_rad_s"), m.frequency, frequency,
                  other.frequency});
    compared.add({std::string("cruise"), std::string("short_period_damping_ratio"), m.damping_ratio, damping,
                  other.damping_ratio});
    const bool good =
        std::fabs(m.frequency / frequency - 1) <= 0.15 && std::fabs(m.damping_ratio - damping) <= 0.12;
    return {good ? Finding::holds : Finding::differs,
            "Short period in cruise: frequency within 15 %, damping ratio within 0.12 of flight.",
            fixed(m.frequency, 2) + " rad/s, " + fixed(m.damping_ratio, 3) + " against " +
                fixed(frequency, 2) + ", " + fixed(damping, 3) +
                ". The centre of gravity of the record is not published."};
  }
  return {Finding::differs, "Short period in cruise.", "No such mode was found."};
}

Finding heave(const Modes& modes, const Modes& others, Table& compared) {
  const Table identified = reference_points("modes_identified").where("mode", std::string("heave"));
  for (int k = 0; k < modes.count; ++k) {
    const Mode<double>& m = modes.mode[k];
    if (m.label.kind != ModeKind::heave) continue;
    const double there = identified.number(0, "real_1_per_s");
    compared.add({std::string("hover"), std::string("heave_1_per_s"), m.real, there,
                  mode_of(others, ModeKind::heave).real});
    constexpr double tolerance = 0.3;
    return {std::fabs(m.real / there - 1) <= tolerance ? Finding::holds : Finding::differs,
            "Heave root in hover within 30 % of flight.",
            fixed(m.real, 3) + " against " + fixed(there, 3) +
                " 1/s. The root is slow and the identification weak there; the flight's weight is not "
                "published."};
  }
  return {Finding::differs, "Heave root in hover.", "No such mode was found."};
}

}  // namespace

Section frequency_responses() {
  Section section{"frequency", "Frequency responses against flight", "", {}, {}, {}};
  section.reading =
      "The complete linear model, rotors and inflow included, against transfer functions identified from "
      "flight "
      "(NASA TM-89428), each over the band for which it was identified.";
  Table compared({"condition", "quantity", "here", "identified", "other"});
  compared.comment("Modes identified in flight: NASA TM-89428. other: of the aircraft as simulated.");
  for (const Case& which : kCases) {
    const ComparedAircraft own = compared_aircraft("transfer_functions");
    const Linear model = model_of(which, own);
    const Linear other = model_of(which, other_aircraft(own));
    const Table table = frequency_table(which, model, other);
    section.pictures.push_back(picture(which, table, "gain", "Gain, dB", "gain_db", "identified_gain_db"));
    section.pictures.push_back(
        picture(which, table, "phase", "Phase, deg", "phase_deg", "identified_phase_deg"));
    section.findings.push_back(judge(which, table, model));
    section.findings.push_back(which.mast_deg > 0 ? short_period(modes_of(model), modes_of(other), compared)
                                                  : heave(modes_of(model), modes_of(other), compared));
    section.tables.push_back({std::string("frequency_") + which.name, which.title, table});
  }
  section.tables.push_back({"modes_compared", "modes against flight", compared});
  return section;
}

}  // namespace tiltrotor::study
