#pragma once

#include <functional>
#include <span>

namespace rubsweep::response {

struct Followed;

/// How long a chaotic motion was seen to last: turns that it and its companions were followed for, and how
/// many of them left it in these turns. Chaos may be a transient of any length: what it leaves a region by is
/// as good as independent of how long it was there, so that its life is exponential with a mean that the
/// turns and the escapes are all that is known of.
struct Survival {
  double turns = 0;
  int escapes = 0;

  /// Lower end of the 95 % confidence interval of the mean life in turns: 2 turns / chi^2_{0.95} with
  /// 2 (escapes + 1) degrees of freedom (B. Epstein, M. Sobel, J. Am. Stat. Assoc. 48 (1953) 486). Without an
  /// escape turns / 2.9957.
  double least_mean_life() const;
};

/// How often chaos is left, and by what.
struct SurvivalOptions {
  int companions = 2;
  int turns = 320;         ///< turns followed per companion, fewer for one that escapes
  int window = 64;         ///< turns without contact that are an escape; a period shows in as many
  int max_order = 12;      ///< a section that returns within so many turns is an escape, too
  double distance = 0.01;  ///< distance of companions, in standard deviations of the section along the motion
};

/// Follows companions from nearby states of the last section of `motion`, which was chaotic for all of its
/// turns; these count, too. `turn` moves a section by a turn, `touched` says whether it saw contact. An
/// escape shows a window after it happened at most, so that the last window of each counts for nothing. A
/// turn that cannot be made ends its companion and is no escape. Depends on its arguments alone.
Survival survive(const std::function<bool(std::span<double> state)>& turn,
                 const std::function<bool()>& touched, const Followed& motion,
                 const SurvivalOptions& options);

}  // namespace rubsweep::response
