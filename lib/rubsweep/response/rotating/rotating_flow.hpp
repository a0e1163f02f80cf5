#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// A stretch of a motion of a rotationally symmetric scene.
struct RotatingArc {
  Eigen::VectorXd end;         ///< state at its end, seen in the frame that turns with the shaft, 2n
  Eigen::MatrixXd transition;  ///< 2n x 2n: d(end) / d(start)
  double angle_rad = 0;        ///< its length, in rotation of the shaft
  int hits = 0;
  double contact_fraction = 0;
  bool slip_reversed = false;  ///< as of a turn
  /// Changes of contact mode, phases from the start of the arc; none where contacts are smoothed.
  std::vector<integrate::run::ModeSwitch> switches;
  double peak_displacement_m = 0;  ///< this and what follows only where samples are asked for
  double peak_contact_force_n = 0;
  double peak_casing_displacement_m = 0;
  Eigen::MatrixXd samples;  ///< 2n x count: states in the fixed frame at phases 2 pi k / N before the end
};

/// Outcome of an arc by Taylor pieces; `by_stepper`: a stepper has to make it.
enum class HowFollowed { made, by_stepper, failed };

/// Follows a rotationally symmetric scene, its pulses left out, and the derivative of the motion by its
/// start, from any state over any angle, by Taylor pieces, or by dopri5 where contacts are
/// smoothed or a stepper is named. In the frame that turns with the shaft such a scene does not depend on
/// time, so that every start is one at phase 0, where the two frames coincide.
class RotatingFlow {
 public:
  /// `samples_per_revolution`: N of RotatingArc::samples; 0: none.
  RotatingFlow(const scene::Scene& scene, const integrate::run::SolverOptions& options,
               int samples_per_revolution);

  /// Flow of the same scene to another tolerance and with other samples. Both share one run, so that they
  /// cannot be used at the same time.
  RotatingFlow with(double relative_tolerance, int samples_per_revolution) const;

  /// Empty when the solver fails. `state`: 2n scaled numbers; `angle_rad` > 0.
  std::optional<RotatingArc> from(const Eigen::VectorXd& state, double angle_rad) const;

  /// The end alone, without its derivative: several times cheaper.
  std::optional<Eigen::VectorXd> end_from(const Eigen::VectorXd& state, double angle_rad) const;

 private:
  struct Common;

  /// Up to the end of `arc`, its transition where it is asked for.
  HowFollowed by_series(const Eigen::VectorXd& state, int samples_per_revolution, bool transition,
                        RotatingArc& arc) const;
  scene::Scene scene_at(const Eigen::VectorXd& state) const;

  std::shared_ptr<Common> common_;
  integrate::run::SolverOptions options_;
  int samples_per_revolution_;
};

}  // namespace rubsweep::response::rotating
