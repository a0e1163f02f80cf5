#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::contact {

/// Slip direction of a touching surface with dry friction, a set-valued law (Filippov). The friction is +mu S
/// in forward slip and -mu S in backward slip, with the spring force S. In a sticking contact it is the force
/// between these bounds that keeps the slip zero.
enum class Slip : unsigned char { forward, sticking, backward };

/// Sign of the slip: +1, 0 or -1.
constexpr double sign_of(Slip slip) { return slip == Slip::forward ? 1 : slip == Slip::backward ? -1 : 0; }

constexpr std::string_view to_string(Slip slip) { return enumerator_word(slip); }

/// Zero band of a slip, as a share of the surface's own speed (or of one clearance per radian). Rounding
/// stays below this limit. Friction would stop a smaller slip within about 1e-12 radians of rotation.
inline constexpr double no_slip = 1e-12;

/// Largest number of stops that may begin to stick at one instant, or stick together.
inline constexpr int most_sticking = 16;

template <int columns>
using StickMatrix = Eigen::Matrix<double, Eigen::Dynamic, columns == 1 ? 1 : Eigen::Dynamic, Eigen::ColMajor,
                                  most_sticking, columns>;
using StickVector = StickMatrix<1>;
using StickMobility = StickMatrix<most_sticking>;

/// Friction forces that keep all surfaces sticking: the solution f of mobility f = acceleration.
StickVector holding_forces(const StickMobility& mobility, const StickVector& acceleration);

/// Slip states after an instant, for surfaces whose slip is zero, and the friction of each surface. The
/// tangents of sticking surfaces are linearly independent, so that their friction is determined.
struct SettledSlips {
  std::array<Slip, most_sticking> slips{};
  /// True where the friction is at its limit, but other surfaces keep the slip from accelerating. Example:
  /// two walls of the same direction on one rigid casing.
  std::array<bool, most_sticking> poised{};
  StickVector force;
  /// Whether the friction obeys the law; only then are the other members valid.
  bool obeys_law = false;
};

/// Decides stick or slip for surfaces with zero slip. `acceleration`: slip acceleration of each surface
/// without any friction. `mobility`: decrease of this acceleration at one surface per unit of friction at
/// another (symmetric, no negative eigenvalue, may be singular). `limit` >= 0: largest friction of each. The
/// friction f found obeys |f| <= limit, with f = limit where the slip then accelerates forward and f = -limit
/// where it accelerates backward. Such an f minimises f.mobility f / 2 - acceleration.f over a box (Gauss's
/// principle of least constraint): a minimum always exists, and all minima give the same motion. Active sets
/// find it in finitely many steps; the law is checked before it is returned.
SettledSlips settle_slips(const StickMobility& mobility, const StickVector& acceleration,
                          const StickVector& limit);

/// Decides stick or slip as above, for surfaces that slip with the friction `sliding` <= limit. As many
/// surfaces as possible stick. A surface that cannot be held even by its limit gets its sliding friction as
/// its new limit, and all surfaces are settled again, in at most as many rounds as there are surfaces. In the
/// end a sticking surface needs at most its limit, and the load on a slipping surface exceeds its friction.
/// `more` is added to the accelerations in the first round, so that a surface at its limit comes loose or is
/// poised.
SettledSlips settle_slips(const StickMobility& mobility, const StickVector& acceleration,
                          const StickVector& more, StickVector limit, const StickVector& sliding);

}  // namespace rubsweep::contact
