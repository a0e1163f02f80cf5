#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/exact/sticking_mode.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::exact {

/// Stretches of a turn between flat stops in which dry friction holds every contact that touches and has any:
/// closed forms and certified steps, so that a rotor held by friction costs as much as a rotor at rest. A
/// stretch ends before any guard can be reached: the event that ends the mode is left to the caller.
class StickingStretch {
 public:
  explicit StickingStretch(const scene::Scene& scene);

  /// State at the start of a stretch, and after `go_on` at its end.
  struct StretchState {
    double phase_rad = 0;
    std::vector<double> state;        ///< as TurnReport::section
    Eigen::MatrixXd tangent_vectors;  ///< as TurnRequest::tangent_vectors
  };

  /// Advances the turn of `report` towards `end_phase_rad`, without pulses or impulses, as far as is certain,
  /// by `most_steps` at most. False, with nothing changed, where a piece of Taylor series would go as far, or
  /// where the modes are not of this kind.
  bool go_on(const run::TurnRequest& request, const std::vector<contact::Mode>& modes,
             const std::vector<contact::Slip>& slips, double end_phase_rad, long most_steps,
             StretchState& place, run::TurnReport& report);

  /// Steps taken since the run began.
  long steps() const { return steps_; }

 private:
  const StickingMode* mode_of(const std::vector<contact::Mode>& modes,
                              const std::vector<contact::Slip>& slips);
  double certified_rad(double longest_rad) const;
  void pass(const run::TurnRequest& request, double duration_rad, StretchState& place,
            run::TurnReport& report);
  void put_samples(const run::TurnRequest& request, double duration_rad, run::TurnReport& report);
  void raise_peaks(double duration_rad, run::TurnReport& report);
  double peak_step_rad() const;

  run::ScaledSystem<Eigen::Dynamic> system_;
  std::vector<bool> dry_, slippery_;  ///< per contact: it can stick, it has no friction at all
  std::map<std::vector<int>, std::optional<StickingMode>> modes_;
  std::vector<int> key_;
  const StickingMode* mode_ = nullptr;
  StickingMotion motion_, at_;
  std::vector<numerics::Pair> flows_;
  Eigen::VectorXd state_, next_;
  long steps_ = 0;
};

}  // namespace rubsweep::integrate::exact
