#pragma once

#include <algorithm>

#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::integrate::run {

/// Work of two solvers together. If a member of Effort is missing here, this does not compile.
inline Effort operator+(const Effort& a, const Effort& b) {
  const auto& [rhs_calls, steps, refused, switches, implicit_steps, taylor_turns, taylor_pieces, creep_pieces,
               taylor_work, adaptive_turns] = b;
  return {.rhs_calls = a.rhs_calls + rhs_calls,
          .steps = a.steps + steps,
          .refused = a.refused + refused,
          .switches = a.switches + switches,
          .implicit_steps = a.implicit_steps + implicit_steps,
          .taylor_turns = a.taylor_turns + taylor_turns,
          .taylor_pieces = a.taylor_pieces + taylor_pieces,
          .creep_pieces = a.creep_pieces + creep_pieces,
          .taylor_work = a.taylor_work + taylor_work,
          .adaptive_turns = a.adaptive_turns + adaptive_turns};
}

/// Bookkeeping of a turn for all solvers: its number, its limit of steps, progress, changes of mode and
/// contact, and the work of the run so far.
class TurnBook {
 public:
  long revolution = 0;  ///< number of the present turn, or of the next one
  Effort effort;

  void begin_turn(const TurnRequest& request) {
    switches_listed_ = request.switches;
    standstill_ = 0;
  }

  /// Allows `most` further steps, accepted or refused.
  void limit_steps(long most) { limit_ = effort.steps + most; }
  bool may_step() const { return effort.steps < limit_; }
  void refuse_step() {
    ++effort.refused;
    --limit_;
  }

  /// Whether so many changes of mode have happened without progress in time that the solver must step over
  /// this instant.
  bool stands_still() const { return standstill_ >= longest_standstill; }
  bool made_progress() const { return standstill_ == 0; }
  void note_progress(bool made) { standstill_ = made ? 0 : standstill_ + 1; }

  void note_switch(const ModeSwitch& change, TurnReport& report) {
    ++effort.switches;
    report.add(change, switches_listed_);
  }

  /// Ends the turn. The contact fraction is clamped, because its parts add up to 1 only within rounding.
  void end_turn(bool touching, TurnReport& report) {
    ++revolution;
    report.contact_fraction = std::clamp(report.contact_fraction, 0.0, 1.0);
    report.touching_at_end = touching;
  }

 private:
  static constexpr int longest_standstill = 16;

  long limit_ = 0;  ///< largest allowed effort.steps
  int standstill_ = 0;
  bool switches_listed_ = false;
};

/// Adds a stretch of contact; `turns`: its duration in turns.
inline void add_contact(double turns, TurnReport& report) {
  report.touched = true;
  report.contact_fraction += turns;
}

}  // namespace rubsweep::integrate::run
