#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::motion {

/// The last two windows of a run, filled turn by turn.
class Record {
 public:
  Record(const scene::Scene& scene, const ResponseOptions& options);

  /// Starts a new record; `section` is the section at the start of the first turn to be recorded.
  void begin(std::span<const double> section);

  /// Adds a turn with `samples_per_revolution` samples and peaks; two windows of turns fill the record.
  void add(const integrate::run::TurnReport& turn);

  Window window(std::size_t which) const;  ///< Window 0 is the older, 1 the newer.

  /// Samples of the observed point over both windows, in metres.
  std::span<const std::complex<double>> displacement_m() const { return displacement_m_; }

 private:
  ResponseOptions options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> map_;  ///< map from scaled displacements to (x, y) in metres
  double length_scale_m_;
  std::size_t states_;
  std::vector<std::complex<double>> displacement_m_;
  std::vector<double> section_;
  std::vector<ContactFacts> facts_;
};

/// Number of turns that a run passes before its motion counts as settled.
struct Settling {
  long most_turns = 0;
  std::optional<int> order{};  ///< settled earlier if the section returns after so many turns
  long fewest_turns = 0;       ///< smallest number of turns before such a return counts
  /// The run is abandoned after more than this number of successive turns without contact, because its motion
  /// has ended.
  std::optional<int> longest_flight{};
  /// The run is abandoned if a contact force in the 17th turn, or in each 16th turn after it, is larger.
  std::optional<double> most_force_n{};
  double most_work = std::numeric_limits<double>::infinity();  ///< limit of the work, including the recording
};

/// Lets a run settle from `turn`, whose section is the current state. Returns the number of turns passed;
/// empty where a turn fails or the run is abandoned.
std::optional<long> pass_until_settled(const integrate::run::Run& run, const Settling& settling,
                                       integrate::run::TurnReport& turn);

/// Adds the samples of a turn at the observed point, x + iy in metres.
void add_samples(const scene::Scene& scene, const integrate::run::TurnReport& turn,
                 std::vector<std::complex<double>>& displacement_m);

/// A recorded turn with its start and the turns that follow.
struct RecordedTurn {
  const integrate::run::TurnReport& report;
  std::span<const double> begin;  ///< section at the start of the turn
  long left = 0;                  ///< turns to come, including this one
};

/// Settings for settling a run and for recording it afterwards.
struct Wanted {
  std::span<const double> start{};  ///< first section, as TurnReport::section; empty: that of the scene
  Settling settling{};
  long turns = 0;                  ///< number of recorded turns
  int samples_per_revolution = 0;  ///< samples in a recorded turn
  bool peaks = false;              ///< true: the contact facts include peaks
  /// If set, receives every recorded turn; SettledRecord::displacement_m then stays empty.
  std::function<void(const RecordedTurn&)> take{};
};

/// Recorded turns of a run.
struct SettledRecord {
  long passed = 0;                                   ///< turns before the first recorded one
  std::vector<std::complex<double>> displacement_m;  ///< x + iy of the observed point
  ContactFacts contact;                              ///< facts over all recorded turns
  bool touched = false;
  std::vector<double> end;  ///< section after the last turn
};

/// Starts a run of the scene, lets it settle and records it. Empty where a turn fails or the run is
/// abandoned.
std::optional<SettledRecord> record_settled(const scene::Scene& scene,
                                            const integrate::run::SolverOptions& solver,
                                            integrate::exact::modes::ModeCache& modes, const Wanted& wanted);

/// The quiet motion at `count` equal angles of a turn, in closed form: x + iy of the observed point in
/// metres.
std::vector<std::complex<double>> quiet_samples(const scene::Cell& cell, int count);

}  // namespace rubsweep::response::motion
