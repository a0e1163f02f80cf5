#include "rubsweep/analysis/design/kick_threshold.hpp"

#include <map>

#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "rubsweep/maps/sweep/threshold.hpp"

namespace rubsweep::design {
namespace {

/// Cell of a study at one speed, run with different kick forces.
class KickedCell {
 public:
  KickedCell(const sweep::Study& study, const scene::PreparedMachine& prepared, const scene::Place& place)
      : study_(study), prepared_(scene::prepared_at(prepared, place.speed_hz)) {
    study_.machine = prepared_.machine;
    study_.grid = sweep::grid_of(place);
    study_.robustness = sweep::Robustness::off;
    study_.basin.reset();
    study_.threshold.reset();
  }

  sweep::Probe kicked_with(double force_n) {
    study_.machine = model::with_kick_force(prepared_.machine, force_n);
    const sweep::Row row =
        sweep::evaluate_cell(study_, scene::prepare_other_kick(prepared_, study_.machine), 0, workspace_);
    const response::motion::MotionClass found = row.motion_class;
    return {response::motion::row_of(found).rubs, found == response::motion::MotionClass::failed,
            sweep::class_and_order(row)};
  }

 private:
  sweep::Study study_;
  scene::PreparedMachine prepared_;
  response::motion::Workspace workspace_;
};

KickThreshold threshold_at(double speed_hz, double force_n, KickedCell& cell) {
  constexpr double tolerance = 0.01;
  KickThreshold found{.speed_hz = speed_hz, .force_n = {}, .motion = {}};
  std::map<double, sweep::Probe>
      known;  // cached results: the threshold search runs the ends of its intervals again
  const auto probe = [&](double force) {
    const auto [at, is_new] = known.try_emplace(force);
    if (is_new) {
      at->second = cell.kicked_with(force);
      found.failed += at->second.failed;
      found.runs = known.size();
    }
    return at->second;
  };
  double before_n = 0;
  if (const sweep::Probe quiet = probe(0); quiet.rubs) {
    found.force_n = 0;
    found.motion = quiet.motion;
    return found;
  }
  for (double factor = smallest_kick; factor <= largest_kick; factor *= 2) {
    if (probe(factor * force_n).rubs) {
      const sweep::ThresholdScan scan{{{"kick.force_n"}, {1}, {before_n, factor * force_n}, {}}, tolerance};
      const sweep::Threshold begin = sweep::find_threshold(scan, probe);
      found.force_n = begin.intervals.front().from;
      found.motion = begin.intervals.front().motions.front();
      return found;
    }
    before_n = factor * force_n;
  }
  return found;
}

}  // namespace

std::vector<KickThreshold> kick_thresholds(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                           double eccentricity_m, std::span<const double> speeds_hz,
                                           int threads, const std::atomic<bool>& stop) {
  std::vector<KickThreshold> found(speeds_hz.size());
  const double force_n = study.machine.kick.value().force_n;
  batch::parallel_run(
      speeds_hz.size(), threads,
      [&](std::size_t k) {
        KickedCell cell(study, prepared, {speeds_hz[k], scene::Eccentricity{eccentricity_m}});
        found[k] = threshold_at(speeds_hz[k], force_n, cell);
      },
      {}, stop);
  return found;
}

}  // namespace rubsweep::design
