#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/followed.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response {

/// Exponents below this, either way, may be slow motions of any kind: one that leaves an unstable periodic
/// motion shows 7e-4, its error bar a hundredth of that.
inline constexpr double chaos_floor = 0.01;
/// An exponent nearer to zero than this counts as zero, whatever its bar: 2000 turns could not tell.
inline constexpr double zero_exponent = 5e-4;
/// The rate at which the closest return grows or shrinks must be known to within this, per turn.
inline constexpr double known_rate = 5e-4;

/// Verdict on a motion without a period.
struct Aperiodic {
  motion::MotionClass motion_class =
      motion::MotionClass::unsettled;        ///< quasi_periodic, chaotic or unsettled
  std::optional<motion::Exponent> exponent;  ///< empty when a turn failed or contact ended
  std::optional<int> returns_after;  ///< turns after which the section returns; the class is then unsettled
  /// True for transient chaos: it was chaotic at first, and then lost its contact or came to a period.
  bool left_chaos = false;
  Followed motion;  ///< all turns that it was followed for
};

/// Follows a motion that showed no period in `turns_before` turns for 640 more; where they do not decide, for
/// as many as make 1280 in all, then for 1280 and for 2560. A turn is one call of `turn`, `touched` says
/// whether it saw contact, `observed` (2 x states / 2) maps displacements to (x, y).
/// - Unsettled at once when a turn fails, or when `window` turns pass without contact.
/// - Unsettled when the section returns, after any number of turns that fits twice into the last two fifths
///   (`returns_after`), or when the exponent is below -chaos_floor beyond its bar: still settling.
/// - Chaotic when the exponent is positive beyond its bar and above chaos_floor, and the motion has gone on
///   for 1280 turns, those before among them.
/// - Quasi-periodic when the exponent is zero within its bar or within zero_exponent, lies with its bar
///   within +-chaos_floor, and the motion returns like a torus.
/// - Else unsettled.
Aperiodic classify_aperiodic(const Growth& turn, const std::function<bool()>& touched,
                             std::vector<double> section, std::size_t turns_before,
                             const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
                             spectrum::SpectrumWorkspace& workspace);

/// Early detection of a torus: a motion that never has a period to be proven, and would take every run to its
/// end. From turn `settled_after` on a tangent vector is carried; tests come 200 turns later and then after a
/// quarter as many again, as long as the window that is to confirm the torus ends before the run's last two
/// begin. Chaos may be a transient and ends no run; but the growth of the tangent vector then counts at the
/// run's end.
class TorusWatch {
 public:
  static constexpr long settled_after = 100;

  /// `wanted`: else nothing is watched, and the windows that are recorded are the run's last.
  TorusWatch(const scene::Scene& scene, const motion::ResponseOptions& options, bool wanted);

  /// The turn after `revolutions` turns is to carry this.
  void ask(long revolutions, integrate::run::TurnRequest& request) const;
  /// Takes in the answer. A solver that moves no tangent vectors ends the watch.
  void add(const integrate::run::TurnRequest& request, const integrate::run::TurnReport& turn);

  /// Revolutions after which it is time for a look; the run's most where none is left.
  long next_look() const { return look_; }
  /// Runs the torus test; on success opens the confirmation window, else schedules the next test.
  void look(spectrum::SpectrumWorkspace& workspace);

  /// Revolutions after which the windows begin that a verdict is made from: two of them, or one where a torus
  /// was seen, since the section has shown what the one before it would.
  long record_begin() const { return record_begin_; }
  /// Exponent of the torus that was seen; else empty.
  const std::optional<motion::Exponent>& torus() const { return torus_; }
  /// The window shows something else than a torus: the watch ends.
  void refuse();

  /// The exponent of a motion that was chaotic from the first turn that was watched up to now, 1280 turns or
  /// more; else empty.
  std::optional<motion::Exponent> chaos() const;
  /// All turns that were watched.
  const Followed& motion() const { return motion_; }

 private:
  void end() { look_ = options_.max_revolutions; }
  long last_windows() const { return options_.max_revolutions - 2L * options_.window_revolutions; }
  bool worth_a_look() const { return look_ + options_.window_revolutions <= last_windows(); }
  bool shows_a_torus(spectrum::SpectrumWorkspace& workspace) const;

  motion::ResponseOptions options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed_;
  Followed motion_;
  Eigen::MatrixXd direction_;  ///< states x 1, unit length
  long look_ = 0, record_begin_ = 0;
  bool chaotic_ = false;  ///< true: chaotic at the last look
  std::optional<motion::Exponent> torus_;
};

}  // namespace rubsweep::response
