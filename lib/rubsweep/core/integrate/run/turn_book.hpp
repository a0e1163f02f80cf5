#pragma once

#include <algorithm>

#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::integrate::run {

/// Work of two solvers together. A member of Effort that is not named here does not compile.
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

/// Life of a turn as every solver keeps it: its number, its limit of steps, progress, changes of mode and
/// contact, and the work of the run so far.
class TurnBook {
 public:
  long revolution = 0;  ///< the one that is made, or comes next
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

  /// Whether so many changes of mode made no progress that this instant is to be stepped over.
  bool stands_still() const { return standstill_ >= longest_standstill; }
  bool made_progress() const { return standstill_ == 0; }
  void note_progress(bool made) { standstill_ = made ? 0 : standstill_ + 1; }

  void note_switch(const ModeSwitch& change, TurnReport& report) {
    ++effort.switches;
    report.add(change, switches_listed_);
  }

  /// The turn is complete: the shares of its steps add up to it but for rounding, and a landing may go back
  /// by rounding.
  void end_turn(bool touching, TurnReport& report) {
    ++revolution;
    report.contact_fraction = std::clamp(report.contact_fraction, 0.0, 1.0);
    report.touching_at_end = touching;
  }

 private:
  static constexpr int longest_standstill = 16;

  long limit_ = 0;  ///< largest effort.steps
  int standstill_ = 0;
  bool switches_listed_ = false;
};

/// Adds a stretch in contact, so many turns long.
inline void add_contact(double turns, TurnReport& report) {
  report.touched = true;
  report.contact_fraction += turns;
}

}  // namespace rubsweep::integrate::run
