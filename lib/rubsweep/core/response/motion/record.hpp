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

  /// Forgets what was recorded; `section` is that at the start of the first turn that will be.
  void begin(std::span<const double> section);

  /// A turn with `samples_per_revolution` samples and peaks; two windows of them fill the record.
  void add(const integrate::run::TurnReport& turn);

  /// 0: the older window, 1: the newer.
  Window window(std::size_t which) const;

  /// Samples of the observed point over both windows, in metres.
  std::span<const std::complex<double>> displacement_m() const { return displacement_m_; }

 private:
  ResponseOptions options_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> map_;  ///< scaled displacements to (x, y) in metres
  double length_scale_m_;
  std::size_t states_;
  std::vector<std::complex<double>> displacement_m_;
  std::vector<double> section_;
  std::vector<ContactFacts> facts_;
};

/// Turns that a run passes before its motion counts as settled.
struct Settling {
  long most_turns = 0;
  std::optional<int> order{};  ///< settled sooner, where its section is that of so many turns ago
  long fewest_turns = 0;       ///< turns before which such a return does not count
  /// The run is given up after more turns in a row without contact: its motion has ended.
  std::optional<int> longest_flight{};
  double most_work = std::numeric_limits<double>::infinity();  ///< limit for the run, recording included
};

/// Lets a run settle from `turn`, whose section is where it stands. Number of turns passed; empty where one
/// fails, or where the run is given up.
std::optional<long> pass_until_settled(const integrate::run::Run& run, const Settling& settling,
                                       integrate::run::TurnReport& turn);

/// Adds the samples of a turn at the observed point, x + iy in metres.
void add_samples(const scene::Scene& scene, const integrate::run::TurnReport& turn,
                 std::vector<std::complex<double>>& displacement_m);

/// A recorded turn.
struct RecordedTurn {
  const integrate::run::TurnReport& report;
  std::span<const double> begin;  ///< section at its start
  long left = 0;                  ///< turns to come, this one included
};

/// How a run settles, and what is recorded of it then.
struct Wanted {
  std::span<const double> start{};  ///< section to begin at, as TurnReport::section; empty: that of the scene
  Settling settling{};
  long turns = 0;                  ///< recorded ones
  int samples_per_revolution = 0;  ///< samples in a recorded turn
  bool peaks = false;              ///< the contact facts hold these
  /// Takes every recorded turn in the place of SettledRecord::displacement_m, which then stays empty.
  std::function<void(const RecordedTurn&)> take{};
};

/// Recorded turns of a run.
struct SettledRecord {
  long passed = 0;                                   ///< turns before the first of them
  std::vector<std::complex<double>> displacement_m;  ///< x + iy of the observed point
  ContactFacts contact;                              ///< facts over all of them
  bool touched = false;
  std::vector<double> end;  ///< section after the last
};

/// Starts a run of the scene, lets it settle and records it. Empty where a turn fails, or where the run is
/// given up.
std::optional<SettledRecord> record_settled(const scene::Scene& scene,
                                            const integrate::run::SolverOptions& solver,
                                            integrate::exact::modes::ModeCache& modes, const Wanted& wanted);

/// The quiet motion at so many equal angles of a turn, from its closed form: x + iy of the observed point in
/// metres.
std::vector<std::complex<double>> quiet_samples(const scene::Cell& cell, int count);

}  // namespace rubsweep::response::motion
