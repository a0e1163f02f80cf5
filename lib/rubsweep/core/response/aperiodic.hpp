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

/// Exponents of smaller magnitude, of either sign, may belong to slow motions of any kind. A motion that
/// leaves an unstable periodic motion shows 7e-4, with an error bar a hundredth of that.
inline constexpr double chaos_floor = 0.01;
/// An exponent of smaller magnitude counts as zero, whatever its error bar, because 2000 turns could not
/// distinguish it from zero.
inline constexpr double zero_exponent = 5e-4;
/// Accuracy, per turn, with which the growth rate of the closest return must be known.
inline constexpr double known_rate = 5e-4;

/// Verdict on a motion without a period.
struct Aperiodic {
  motion::MotionClass motion_class =
      motion::MotionClass::unsettled;        ///< quasi_periodic, chaotic or unsettled
  std::optional<motion::Exponent> exponent;  ///< empty when a turn failed or contact ended
  /// number of turns after which the section returns, for class unsettled
  std::optional<int> returns_after;
  /// True for transient chaos: the motion was chaotic at first, then lost its contact or became periodic.
  bool left_chaos = false;
  Followed motion;  ///< all turns for which the motion was followed
};

/// Follows a motion without a period in `turns_before` turns for 640 more turns. If these do not decide, it
/// follows on until there are 1280 turns in all, then until 1280 and 2560 followed turns. A turn is one call
/// of `turn`; `touched` says whether it had contact; `observed` (2 x states / 2) maps displacements to (x,
/// y).
/// - Unsettled at once when a turn fails, or when `window` turns pass without contact.
/// - Unsettled when the section returns after a number of turns (`returns_after`) that fits twice into the
/// last two fifths, or when the exponent is below -chaos_floor beyond its error bar: still settling.
/// - Chaotic when the exponent is positive beyond its error bar and above chaos_floor, and the motion has
/// lasted 1280 turns, `turns_before` included.
/// - Quasi-periodic when the exponent is zero within its error bar or within zero_exponent, lies with its
/// error bar within +-chaos_floor, and the motion returns like a torus.
/// - Otherwise unsettled.
Aperiodic classify_aperiodic(const Growth& turn, const std::function<bool()>& touched,
                             std::vector<double> section, std::size_t turns_before,
                             const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
                             spectrum::SpectrumWorkspace& workspace);

/// Early detection of a torus, which has no period that could be proven, so that each run would take its full
/// length. From turn `settled_after` on, a tangent vector is carried along. The first test comes 200 turns
/// later. Each further test comes when the number of turns has grown by a quarter, as long as the confirming
/// window ends before the last two windows of the run. Chaos may be transient and ends no run, but the growth
/// of the tangent vector is used at the end of the run.
class TorusWatch {
 public:
  static constexpr long settled_after = 100;

  /// `wanted` = false: no torus is searched for, and the last windows of the run are recorded.
  TorusWatch(const scene::Scene& scene, const motion::ResponseOptions& options, bool wanted);

  /// Adds the tangent vector to the request for the turn after `revolutions` turns, if it is carried in this
  /// turn.
  void ask(long revolutions, integrate::run::TurnRequest& request) const;
  /// Reads the report of that turn. A solver that moves no tangent vectors ends the watch.
  void add(const integrate::run::TurnRequest& request, const integrate::run::TurnReport& turn);

  /// Revolutions after which the next test is due; the largest number of revolutions of the run when no test
  /// remains.
  long next_look() const { return look_; }
  /// Makes the torus test. If it succeeds, the confirming window begins; otherwise the next test is
  /// scheduled.
  void look(spectrum::SpectrumWorkspace& workspace);

  /// Revolutions after which recording for the verdict begins: two windows before the end, or only one after
  /// a torus was found, because its section has already shown what the first window would show.
  long record_begin() const { return record_begin_; }
  /// Exponent of the torus that was found; otherwise empty.
  const std::optional<motion::Exponent>& torus() const { return torus_; }
  /// Ends the watch, because the confirming window shows something other than a torus.
  void refuse();

  /// Exponent of a motion that has been chaotic since watching began, for at least 1280 turns; otherwise
  /// empty.
  std::optional<motion::Exponent> chaos() const;
  /// All watched turns.
  const Followed& motion() const { return motion_; }

 private:
  void end() { look_ = options_.max_revolutions; }
  long last_windows() const { return options_.max_revolutions - 2L * options_.window_revolutions; }
  bool worth_a_look() const { return look_ + options_.window_revolutions <= last_windows(); }
  bool shows_a_torus(spectrum::SpectrumWorkspace& workspace) const;

  motion::ResponseOptions options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed_;
  Followed motion_;
  Eigen::MatrixXd direction_;  ///< tangent vector, states x 1, of unit length
  long look_ = 0, record_begin_ = 0;
  bool chaotic_ = false;  ///< true: chaotic at the last test
  std::optional<motion::Exponent> torus_;
};

}  // namespace rubsweep::response
