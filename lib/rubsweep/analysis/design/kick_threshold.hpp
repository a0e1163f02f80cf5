#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::design {

/// Smallest kick at one speed after which rub persists.
struct KickThreshold {
  double speed_hz = 0;
  std::optional<double> force_n;  ///< empty: no kick leads to persistent rub; 0: the quiet motion itself rubs
  std::string motion;      ///< class and order of the rub, such as "subharmonic 1/2"; empty without a rub
  std::size_t runs = 0;    ///< cells that were simulated
  std::size_t failed = 0;  ///< number of failed runs, which count as no rub
};

/// Range of the kick's force, as multiples of the configuration's force. Where rub begins between two tried
/// forces, the force is bisected to a hundredth.
inline constexpr double smallest_kick = 1.0 / 16, largest_kick = 4;

/// Varies the force of the machine's kick at each speed, from the smallest force on by factors of 2, and
/// bisects (sweep/threshold) where rub first persists. Everything else in kick and study stays unchanged. A
/// range of forces with rub that is narrower than a factor of 2 may be missed. The machine must have a kick
/// of more than 0 N. `threads` as in batch::parallel_run.
std::vector<KickThreshold> kick_thresholds(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                           double eccentricity_m, std::span<const double> speeds_hz,
                                           int threads, const std::atomic<bool>& stop);

}  // namespace rubsweep::design
