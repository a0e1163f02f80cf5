#pragma once

#include <Eigen/Core>
#include <array>
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

/// Stretches of a turn in which dry friction holds every touching contact that has any. Closed forms and
/// certified steps make a rotor held by friction as cheap as a rotor at rest. A stretch ends before any guard
/// can be reached; the caller handles the event that ends the mode. An annular stop without surface speed
/// (contact radius 0) counts as a flat wall while the rotor sticks to it, because its normal does not turn.
class StickingStretch {
 public:
  explicit StickingStretch(const scene::Scene& scene);

  /// State at the start of a stretch and, after `go_on`, at its end.
  struct StretchState {
    double phase_rad = 0;
    std::vector<double> state;        ///< state as in TurnReport::section
    Eigen::MatrixXd tangent_vectors;  ///< vectors as in TurnRequest::tangent_vectors
  };

  /// Continues the turn of `report` towards `end_phase_rad`, without pulses or impulses, as far as is
  /// certain, with at most `most_steps` steps. False, with nothing changed, where a Taylor piece would reach
  /// as far, or where the contacts do not stick in this way.
  bool go_on(const run::TurnRequest& request, const std::vector<contact::Mode>& modes,
             const std::vector<contact::Slip>& slips, double end_phase_rad, long most_steps,
             StretchState& place, run::TurnReport& report);

  /// Number of steps since the run began.
  long steps() const { return steps_; }

 private:
  const StickingMode* mode_of(const std::vector<contact::Mode>& modes,
                              const std::vector<contact::Slip>& slips, std::span<const double> state);
  run::ScaledSystem<Eigen::Dynamic> with_flat_rings() const;
  double certified_rad(double longest_rad) const;
  void pass(const run::TurnRequest& request, double duration_rad, StretchState& place,
            run::TurnReport& report);
  void put_samples(const run::TurnRequest& request, double duration_rad, run::TurnReport& report);
  void raise_peaks(double duration_rad, run::TurnReport& report);
  void raise_peaks_by_blocks(double blocks, double block, double size, run::TurnReport& report);
  void raise_peaks_by_cubics(double pieces, double size, run::TurnReport& report);
  double peak_step_rad() const;

  run::ScaledSystem<Eigen::Dynamic> system_;
  /// A force, or the length of a vector, whose peak is reported.
  struct Watched {
    bool length = false;
    std::array<StickingView, 2> views;  ///< the force; or x and y of the vector
    double scale = 1;                   ///< factor to the unit of the report
    double run::TurnReport::*peak = nullptr;
  };
  /// A mode, and the normals of the annular stops for which it was made, in the order of the contacts.
  struct MadeMode {
    std::vector<Eigen::Vector2d> normals;
    std::optional<StickingMode> mode;
    std::vector<Watched> watched;
  };
  /// Place where the bound of a peak is highest.
  struct Promising {
    double bound = 0;
    StickingMotion at;
  };

  void watch(MadeMode& made) const;
  double bound(const Watched& watched, double duration_rad) const;

  /// per contact: whether it can stick; whether its friction is independent of the slip
  std::vector<bool> dry_, steady_;
  std::map<std::vector<int>, MadeMode> modes_;
  std::vector<int> key_;
  std::vector<bool> sticks_;
  std::vector<double> ways_;              ///< slip signs of contacts that do not stick, 0 without friction
  std::vector<Eigen::Vector2d> normals_;  ///< normals as in MadeMode, at the present motion
  const StickingMode* mode_ = nullptr;
  const MadeMode* made_ = nullptr;
  StickingMotion motion_, at_, before_;
  std::vector<Promising> promising_;
  std::vector<numerics::Pair> flows_, block_flows_;
  Eigen::VectorXd state_;
  long steps_ = 0;
};

}  // namespace rubsweep::integrate::exact
