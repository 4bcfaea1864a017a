#include "cli/mast_moves.hpp"

#include <algorithm>
#include <cmath>

#include "cli/arguments.hpp"
#include "cli/errors.hpp"
#include "text/number.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace tiltrotor::cli {

namespace {

constexpr Range time_range{0, 3600, "s"};
constexpr double kSameTime = 1e-9;  // s

double degrees(double angle) { return angle * kDegPerRad<double>; }

}  // namespace

bool is_mast_move(const std::string& input) { return input.compare(0, 5, "mast=") == 0; }

MastMove parse_mast_move(const std::string& text, const std::string& where_option) {
  const std::string where = where_option + " " + text;
  const std::size_t at = text.find('@'), dots = text.find("..");
  if (at == std::string::npos || dots == std::string::npos || dots < at)
    throw UsageError(where + ": not mast=CHANGE[deg]@START..END, for example mast=30deg@1..5");
  std::string change = text.substr(5, at - 5);
  if (change.size() > 3 && change.compare(change.size() - 3, 3, "deg") == 0) change.resize(change.size() - 3);
  const LimitTables<double>& limits = aircraft_data<double>().limits;
  const double most = limits.mast_deg.high - limits.mast_deg.low;
  MastMove move{};
  move.change = parse_number(change, where, {-most, most, "deg"}) * kRadPerDeg<double>;
  move.start = parse_number(text.substr(at + 1, dots - at - 1), where, time_range);
  move.end = parse_number(text.substr(dots + 2), where, time_range);
  if (move.end <= move.start) throw UsageError(where + ": the end is not after the start");
  const double rate = move.change / (move.end - move.start);
  if (!is_within(rate, limits.mast_rate.low, limits.mast_rate.high)) {
    throw UsageError(where + ": a rate of " + number_text(degrees(rate), 6) + " deg/s lies outside " +
                     number_text(degrees(limits.mast_rate.low), 6) + ".." +
                     number_text(degrees(limits.mast_rate.high), 6) + " deg/s");
  }
  return move;
}

void MastMoves::add(const MastMove& move, const std::string& where) {
  const auto next = std::find_if(moves_.begin(), moves_.end(),
                                 [&move](const MastMove& other) { return other.start >= move.start; });
  const bool before = next != moves_.end() && next->start < move.end;
  const bool after = next != moves_.begin() && std::prev(next)->end > move.start;
  if (before || after) throw UsageError(where + ": two moves of the masts at the same time");
  moves_.insert(next, move);
}

void MastMoves::require_range(double mast_deg, const std::string& where) const {
  const Bounds<double> range = aircraft_data<double>().limits.mast_deg;
  double mast = mast_deg;
  for (const MastMove& move : moves_) {
    mast += degrees(move.change);
    if (!is_within(mast, range.low - 1e-9, range.high + 1e-9)) {
      throw UsageError(where + ": leads the masts to " + number_text(mast, 6) + " deg, outside " +
                       number_text(range.low) + ".." + number_text(range.high) + " deg");
    }
  }
}

double MastMoves::rate_after(double time) const {
  for (const MastMove& move : moves_)
    if (time >= move.start - kSameTime && time < move.end - kSameTime)
      return move.change / (move.end - move.start);
  return 0;
}

double MastMoves::next_edge(double after, double before) const {
  double next = before;
  for (const MastMove& move : moves_)
    for (const double edge : {move.start, move.end})
      if (edge > after + kSameTime && edge < next - kSameTime) next = edge;
  return next;
}

Status MastMoves::advance(Configuration<double>& c, FeedbackFlight& flight, Simulation<double>& s) const {
  const double dt = s.dt, end = current_time(s) + dt;
  bool is_cut = false;
  Status status = Status::ok;
  for (double now = current_time(s); status == Status::ok && now < end - kSameTime;) {
    ConfigurationSetting<double> setting = c.setup;
    setting.mast_rate = rate_after(now);
    if (setting.mast_rate != c.setup.mast_rate) status = change_configuration(setting, c, s);
    const double edge = next_edge(now, end);
    if (edge < end || is_cut) {
      is_cut = true;
      if (status == Status::ok) status = change_step(s, edge - now);
    }
    if (status == Status::ok) status = flight.advance(c, s);
    now = edge;
  }
  if (is_cut && status == Status::ok) status = change_step(s, dt);
  return status;
}

}  // namespace tiltrotor::cli
