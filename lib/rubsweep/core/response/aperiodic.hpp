#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/core/response/followed.hpp"
#include "rubsweep/core/response/growth.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response {

/// Exponents below this, either way, may be slow motions of any kind: one that leaves an unstable periodic
/// motion shows 7e-4, its error bar a hundredth of that.
inline constexpr double chaos_floor = 0.01;
/// An exponent nearer to zero than this counts as zero, whatever its bar: 2000 turns could not tell.
inline constexpr double zero_exponent = 5e-4;
/// The rate at which the closest return grows or shrinks must be known to within this, per turn.
inline constexpr double known_rate = 5e-4;

/// Verdict on a motion without a period.
struct Aperiodic {
  motion::MotionClass motion_class =
      motion::MotionClass::unsettled;        ///< quasi_periodic, chaotic or unsettled
  std::optional<motion::Exponent> exponent;  ///< empty when a turn failed or contact ended
  std::optional<int> returns_after;  ///< turns after which the section returns; the class is then unsettled
  /// True for transient chaos: it was chaotic at first, and then lost its contact or came to a period.
  bool left_chaos = false;
  Followed motion;  ///< all turns that it was followed for
};

/// Follows a motion that showed no period in `turns_before` turns for 640 more; where they do not decide, for
/// as many as make 1280 in all, then for 1280 and for 2560. A turn is one call of `turn`, `touched` says
/// whether it saw contact, `observed` (2 x states / 2) maps displacements to (x, y).
/// - Unsettled at once when a turn fails, or when `window` turns pass without contact.
/// - Unsettled when the section returns, after any number of turns that fits twice into the last two fifths
///   (`returns_after`), or when the exponent is below -chaos_floor beyond its bar: still settling.
/// - Chaotic when the exponent is positive beyond its bar and above chaos_floor, and the motion has gone on
///   for 1280 turns, those before among them.
/// - Quasi-periodic when the exponent is zero within its bar or within zero_exponent, lies with its bar
///   within +-chaos_floor, and the motion returns like a torus.
/// - Else unsettled.
Aperiodic classify_aperiodic(const Growth& turn, const std::function<bool()>& touched,
                             std::vector<double> section, std::size_t turns_before,
                             const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed, int window,
                             spectrum::SpectrumWorkspace& workspace);

/// The exponent of a motion that has been chaotic for as long as it was followed: 1280 turns or more, the
/// exponent positive beyond its bar and above chaos_floor, by smooth weights in either half as well, and a
/// section that does not return. Empty for any other.
std::optional<motion::Exponent> lasting_chaos(const Followed& motion);

}  // namespace rubsweep::response
