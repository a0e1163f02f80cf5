#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::answer {

/// Causes of vibration other than a rub that have lines of their own.
enum class ForeignCause {
  mains_hum,      ///< lines at 50 or 60 Hz and twice that, whatever the speed
  run_out,        ///< a profile of the surface, seen by the second probe later by the angle between both
  misalignment,   ///< 2X
  cracked_shaft,  ///< 2X at half the critical speed
  looseness,      ///< many multiples along one direction
  oil_whirl,      ///< forward at 0.38X to 0.495X
  self_excited,   ///< forward below 1X at the natural frequency
  bearing_fault,  ///< a line above 2X that belongs to no fraction, its multiples and their sidebands
  second_mode     ///< lines between the multiples far above the natural frequency of a rotor with one mode
};
constexpr std::string_view to_string(ForeignCause cause) { return enumerator_word(cause); }
std::string_view words_for(ForeignCause cause);

/// A cause whose lines a recording has.
struct ForeignSign {
  ForeignCause cause = ForeignCause::mains_hum;
  double share = 0;  ///< share, 0 to 1, of the energy off +1X and -1X that these lines hold
  double order = 0;  ///< order of the strongest of them, negative: backward
};

/// Facts beside the lines.
struct ForeignQuestion {
  double speed_hz = 0;
  double natural_frequency_hz = 0;                             ///< 0: not known
  bool one_mode = false;                                       ///< whether the simulated rotor has one mode
  std::optional<std::pair<double, double>> probe_angle_deg{};  ///< directions of two probes; empty: one probe
};

/// Causes whose lines hold half or more of the energy off 1X, the largest share first; none where that energy
/// is below 0.3 % of all. The rules are those of docs/method/diagnosis.md. A rub may have the same lines, so
/// that a sign counts only where no rub explains the recording.
std::vector<ForeignSign> foreign_signs(const MotionLines& lines, const ForeignQuestion& question);

}  // namespace rubsweep::diagnose::answer
