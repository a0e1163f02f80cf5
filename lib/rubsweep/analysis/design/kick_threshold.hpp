#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::design {

/// The smallest kick after which rub goes on, at one speed.
struct KickThreshold {
  double speed_hz = 0;
  std::optional<double> force_n;  ///< empty: rub goes on after none of the kicks; 0: the quiet motion rubs
  std::string motion;      ///< class and order of the rub, such as "subharmonic 1/2"; empty without one
  std::size_t runs = 0;    ///< cells that were simulated
  std::size_t failed = 0;  ///< number of runs that failed: they count as not rubbing
};

/// Kicks to try, as multiples of the configuration's force; between those where rub begins the force is
/// bisected to a hundredth.
inline constexpr double smallest_kick = 1.0 / 16, largest_kick = 4;

/// Scans the force of the machine's kick at each speed, from the smallest on by factors of 2, and bisects
/// (sweep/threshold) where rub first goes on; all else of the kick and of the study as it is. What lies below
/// in an interval narrower than such a factor may be missed. The machine must have a kick of more than 0 N.
/// `threads` as in batch::parallel_run.
std::vector<KickThreshold> kick_thresholds(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                           double eccentricity_m, std::span<const double> speeds_hz,
                                           int threads, const std::atomic<bool>& stop);

}  // namespace rubsweep::design
