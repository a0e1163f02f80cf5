#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/followed.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response {

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
  bool chaotic_ = false;  ///< at its last look
  std::optional<motion::Exponent> torus_;
};

}  // namespace rubsweep::response
