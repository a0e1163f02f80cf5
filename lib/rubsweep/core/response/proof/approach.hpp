#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::proof {

/// Norms |norm[i] x| on the sections of an orbit in which every turn is a contraction.
struct AdaptedNorms {
  std::vector<Eigen::MatrixXd> norm;  ///< norm in each turn of the period, upper triangular; never below |x|
  double contraction = 0;             ///< |norm[i + 1] A_i x| <= contraction |norm[i] x|, < 1
};

/// Norms for the turns `transitions` (derivatives A_0, A_1, ... of one section by the one before) of an orbit
/// whose multipliers lie inside the unit circle: norm[i]^T norm[i] = P_i with
///   P_i = 1 + A_i^T P_{i+1} A_i / contraction^2,   P_n = P_0,
/// the discrete Lyapunov equation of the period, solved by doubling. `contraction` over the period lies
/// halfway between the largest multiplier and 1, so that the norms do not degenerate. In the maximum norm,
/// on the contrary, a disturbance that spirals in may seem to shrink where it only turns. Empty where the
/// largest multiplier is not below 1, or so near to it that rounding decides.
std::optional<AdaptedNorms> adapted_norms(const std::vector<Eigen::MatrixXd>& transitions);

/// Norms on the sections of an orbit as AdaptedNorms, but separate for two parts of a disturbance: the *slow*
/// part, which no contact sees, is a free vibration along flat walls that only the structure's own damping
/// takes away, the *fast* one all the rest.
struct SplitNorms {
  /// Per turn, on a section: the first `fast` rows give the fast part in its norm, the others the slow one.
  std::vector<Eigen::MatrixXd> norm;
  std::vector<Eigen::MatrixXd> unit;  ///< their inverses
  Eigen::Index fast = 0;
  /// Contraction of either part by every turn, < 1; besides, the fast part drives the slow one.
  integrate::exact::tube::Parts contraction;

  Eigen::Index slow() const { return norm.front().rows() - fast; }
};

/// The rows on a section by which the contacts of a scene see it: penetrations, then their rates.
Eigen::MatrixXd seen_by_contacts(const scene::Scene& scene);

/// Norms for the turns `transitions` of an orbit, see adapted_norms. `seen` is seen_by_contacts. A multiplier
/// belongs to the slow part where its eigenvectors are zero in all of these, to rounding, and where it loses
/// less than half in a turn. Each part has the adapted norm of what the orbit's turns make of it: of the slow
/// part, which the turns keep to itself, and of sections up to it. Empty where there is no slow part, no
/// other, or no norm.
std::optional<SplitNorms> split_norms(const std::vector<Eigen::MatrixXd>& transitions,
                                      const Eigen::MatrixXd& seen);

/// Lengths of the two parts of `offset` from section `turn` of the orbit.
integrate::exact::tube::Parts parts_of(const SplitNorms& norms, std::size_t turn,
                                       const Eigen::VectorXd& offset);

/// Test for linear convergence of a transient to its orbit: counts successive returns that the derivative of
/// the return map predicts to within a tenth of what a return gains. The error is of second order in the
/// distance, so that it is less nearer by: where several returns in a row pass and half of the distance is
/// gone, the transient is on its way to the orbit.
/// Beside a fold or a torus bifurcation an orbit attracts by next to nothing, and the error may be larger for
/// long: it speeds the approach up, or turns it by an angle that goes with the distance, so that the
/// predicted point is far off and yet as near to the orbit. There as many returns in a row count as halve the
/// distance at the promised rate, each of which gained nine tenths of that or more. A transient behind the
/// unstable orbit or torus of that bifurcation gains nothing.
class LinearConvergenceTest {
 public:
  /// `in_a_row`: number of returns, or turns of them, that have to be predicted.
  explicit LinearConvergenceTest(int in_a_row) : in_a_row_(in_a_row) {}

  /// One more return, or turn of one, which came `error` off from the prediction, from `distance` away in a
  /// norm that the derivative multiplies by `contraction` or less, 0 < contraction < 1.
  void add_prediction(double error, double distance, double contraction) {
    predicted_ = error <= predicted_within * (1 - contraction) * distance ? predicted_ + 1 : 0;
  }
  /// One more return, which came from `before` to `now` away in such a norm.
  void add_contraction(double before, double now, double contraction) {
    gained_ = before - now >= gained_at_least * (1 - contraction) * before ? gained_ + 1 : 0;
    halving_ = std::numbers::ln2 / -std::log(contraction);
  }

  /// Whether the test is passed now that `distance` is left of `first`.
  bool passed(double distance, double first) const {
    const bool on_its_way = predicted_ >= in_a_row_ || (gained_ > 0 && gained_ >= halving_);
    return on_its_way && distance < followed_down * first;
  }

 private:
  static constexpr double followed_down = 0.5, predicted_within = 0.1, gained_at_least = 0.9;

  int in_a_row_, predicted_ = 0, gained_ = 0;
  double halving_ = 0;
};

/// Turns (or returns) that following a transient towards an orbit may take: three times what the norm
/// promises near the orbit, and some at the start, where the transient is not yet near.
struct Patience {
  double start = 0;
  double most = 0;

  /// Limit where the norm promises to get as near as it must in `promised` turns.
  double turns(double promised) const { return std::min(most, start + times_promised * promised); }
  /// Up to `now`, from `first` away, in a norm that every turn multiplies by `contraction` or less: a
  /// transient that is not as near by then is on its way to somewhere else.
  double turns(double contraction, double first, double now) const {
    return turns(std::log(std::max(1.0, first / now)) / -std::log(contraction));
  }

 private:
  static constexpr double times_promised = 3;
};

/// Criteria for being near an orbit: any of these is enough.
struct Nearness {
  double adapted = 0;  ///< distance in the adapted norm of the turn
  double largest = 0;  ///< or this largest component of it, in (clearance, clearance omega)
  /// Or half of the first distance, by LinearConvergenceTest with the turns of three periods.
  bool converges = false;
};

/// Follows a transient, which is at `section` where the orbit is at its first section, turn by turn until it
/// is near the orbit. False when a turn fails, when it gets four times as far from the orbit as it was, and
/// when it takes more turns than `patience` allows.
bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, const Patience& patience);

/// The same until both parts of `norms` are within `radii`, with the distance in the norm that has these
/// radii as its ball. False after `most_turns`, too.
bool comes_inside(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                  const SplitNorms& norms, const integrate::exact::tube::Parts& radii, double most_turns);

/// Distance of a section from the orbit's first one in the adapted norm there.
double adapted_distance(std::span<const double> section, const StableOrbit& orbit, const AdaptedNorms& norms);

}  // namespace rubsweep::response::proof
