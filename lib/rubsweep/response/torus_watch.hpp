#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/response/followed.hpp"
#include "rubsweep/response/motion/motion.hpp"
#include "rubsweep/response/motion/options.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response {

/// Looks now and then, while a run goes on, whether it has come to a torus: a motion that never has a period
/// to be proven, and would else take every run to its end. From turn `settled_after` on a tangent vector is
/// carried; looks come 200 turns later and then after half as many again, as long as the last of them still
/// saves two windows. Chaos is never decided here: what looks like it may be a transient.
class TorusWatch {
 public:
  static constexpr long settled_after = 200;

  /// `wanted`: else nothing is watched, and the next look is the end of the run.
  TorusWatch(const scene::Scene& scene, const motion::ResponseOptions& options, bool wanted);

  /// The turn after `revolutions` turns is to carry this.
  void ask(long revolutions, integrate::run::TurnRequest& request) const;
  /// Takes in what was answered. A solver that moves no tangent vectors ends the watch.
  void add(const integrate::run::TurnRequest& request, const integrate::run::TurnReport& turn);

  /// Revolutions after which it is time for a look; the run's most where none is left.
  long next_look() const { return look_; }
  /// The exponent of a torus, or nothing. Sets the next look.
  std::optional<motion::Exponent> look(spectrum::SpectrumWorkspace& workspace);

 private:
  void end() { look_ = options_.max_revolutions; }

  motion::ResponseOptions options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed_;
  Followed motion_;
  Eigen::MatrixXd direction_;  ///< states x 1, unit length
  long look_ = 0;
};

}  // namespace rubsweep::response
