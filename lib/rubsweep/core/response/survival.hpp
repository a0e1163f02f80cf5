#pragma once

#include <functional>
#include <span>

namespace rubsweep::response {

struct Followed;

/// Observed survival of a chaotic motion: the number of turns for which the motion and its companions were
/// followed, and the number of escapes. Chaos may be a transient of any length. Its escape is practically
/// independent of the time already spent, so that its life has an exponential distribution. Turns and escapes
/// are all that is known about the mean life.
struct Survival {
  double turns = 0;
  int escapes = 0;

  /// Lower end of the 95 % confidence interval of the mean life in turns: 2 turns / chi^2_{0.95} with 2
  /// (escapes + 1) degrees of freedom (B. Epstein, M. Sobel, J. Am. Stat. Assoc. 48 (1953) 486). Without an
  /// escape this is turns / 2.9957.
  double least_mean_life() const;
};

/// Settings for following companions of a chaotic motion, and criteria for an escape.
struct SurvivalOptions {
  int companions = 2;
  int turns = 320;  ///< largest number of turns per companion
  /// number of turns without contact that count as an escape; also number of turns to show a period
  int window = 64;
  int max_order = 12;      ///< a section that returns within so many turns is also an escape
  double distance = 0.01;  ///< distance of companions from the motion, in standard deviations of its section
};

/// Follows companions from states near the last section of `motion`, whose own turns, all chaotic, count too.
/// `turn` moves a section by a turn; `touched` says whether it had contact. An escape shows at most one
/// window after it happened, so that the last window of each companion is not counted. A turn that cannot be
/// computed ends its companion and is no escape. The result depends only on the arguments.
Survival survive(const std::function<bool(std::span<double> state)>& turn,
                 const std::function<bool()>& touched, const Followed& motion,
                 const SurvivalOptions& options);

}  // namespace rubsweep::response
