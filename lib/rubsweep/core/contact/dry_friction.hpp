#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::contact {

/// Which way a touching surface slips whose friction is dry, a set at slip zero (Filippov): +mu S while it
/// slips forward, -mu S while it slips backward, S being the spring force, and whatever holds it within these
/// two while it sticks.
enum class Slip : unsigned char { forward, sticking, backward };

/// +1, 0, -1.
constexpr double sign_of(Slip slip) { return slip == Slip::forward ? 1 : slip == Slip::backward ? -1 : 0; }

constexpr std::string_view to_string(Slip slip) { return enumerator_word(slip); }

/// Zero band of a slip, as a share of the surface's own speed (or of one clearance a radian): rounding stays
/// below it, and friction would stop a smaller slip within as many radians.
inline constexpr double no_slip = 1e-12;

/// Stops that may come to stick at one instant, or stick together.
inline constexpr int most_sticking = 16;

template <int columns>
using StickMatrix = Eigen::Matrix<double, Eigen::Dynamic, columns == 1 ? 1 : Eigen::Dynamic, Eigen::ColMajor,
                                  most_sticking, columns>;
using StickVector = StickMatrix<1>;
using StickMobility = StickMatrix<most_sticking>;

/// Forces that hold every one of the surfaces: mobility f = acceleration.
StickVector holding_forces(const StickMobility& mobility, const StickVector& acceleration);

/// Slip states from one instant on of surfaces whose slip is zero, and the friction of each. Tangents of
/// sticking surfaces are independent of each other: their friction is determined.
struct SettledSlips {
  std::array<Slip, most_sticking> slips{};
  /// Friction at its limit, and still no acceleration of the slip: others keep the surface standing. So does
  /// one wall with another one of its direction on the same rigid casing.
  std::array<bool, most_sticking> poised{};
  StickVector force;
  /// The friction obeys the law; false for numbers that are not finite, too. Nothing else may be used then.
  bool obeys_law = false;
};

/// Decides stick or slip for surfaces with zero slip. `acceleration` is that of each slip without friction at
/// any of them, `mobility` the decrease of the acceleration at one per unit of friction at another
/// (symmetric, no negative eigenvalue, may be singular), `limit` >= 0 the largest friction of each. The
/// friction sought obeys |f| <= limit, f = limit where the slip then accelerates forward and f = -limit where
/// it does backward. That is the minimum of f.mobility f / 2 - acceleration.f over a box (Gauss's principle
/// of least constraint): there always is one, and the motion that follows is the same for all minima. It is
/// found by active sets in finitely many steps, and tried against the law before it is returned.
SettledSlips settle_slips(const StickMobility& mobility, const StickVector& acceleration,
                          const StickVector& limit);

/// The same where surfaces slip with the friction `sliding` <= limit. Each sticks that can: one that not even
/// its limit holds has its sliding friction for its limit from there on, and all are settled again. So one
/// after another comes loose, in as many rounds as there are surfaces at most; what then sticks needs no more
/// than its limit, and what slips is pushed on by more than its friction. `more` is added to the
/// accelerations in the first round, so that a surface which is at its limit comes loose or is poised.
SettledSlips settle_slips(const StickMobility& mobility, const StickVector& acceleration,
                          const StickVector& more, StickVector limit, const StickVector& sliding);

}  // namespace rubsweep::contact
