// Masts that move during a flight, as text and on their way: mast=CHANGE[deg]@START..END.
#pragma once

#include <string>
#include <vector>

#include "cli/feedback_flight.hpp"

namespace tiltrotor::cli {

// At a constant rate from start to end.
struct MastMove {
  double start, end;  // s
  double change;      // rad
};

bool is_mast_move(const std::string& input);
// Throws UsageError "<where>: ...".
MastMove parse_mast_move(const std::string& text, const std::string& where);

// The moves of a flight, one after the other.
class MastMoves {
 public:
  // Throws UsageError when two moves overlap.
  void add(const MastMove& move, const std::string& where);
  bool is_empty() const { return moves_.empty(); }
  // Throws UsageError when the masts leave their range on the way.
  void require_range(double mast_deg, const std::string& where) const;

  // One step, cut where a move begins or ends.
  Status advance(Configuration<double>& c, FeedbackFlight& flight, Simulation<double>& s) const;

 private:
  double rate_after(double time) const;
  double next_edge(double after, double before) const;

  std::vector<MastMove> moves_;  // in order
};

}  // namespace tiltrotor::cli
