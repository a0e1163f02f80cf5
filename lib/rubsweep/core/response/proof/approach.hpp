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
  std::vector<Eigen::MatrixXd> norm;  ///< norm at each turn of the period, upper triangular; never below |x|
  double contraction = 0;             ///< |norm[i + 1] A_i x| <= contraction |norm[i] x|, < 1
};

/// Norms for the turns of an orbit whose multipliers lie inside the unit circle. `transitions` are the
/// derivatives A_0, A_1, ... of each section by the one before. norm[i]^T norm[i] = P_i with
/// P_i = 1 + A_i^T P_{i+1} A_i / contraction^2,   P_n = P_0,
/// the discrete Lyapunov equation of the period, solved by doubling. The contraction over the period is
/// halfway between the largest multiplier and 1, so that the norms do not degenerate. (In the maximum norm, a
/// disturbance that spirals in may seem to shrink where it only turns.) Empty where the largest multiplier is
/// not below 1, or so near to it that rounding decides.
std::optional<AdaptedNorms> adapted_norms(const std::vector<Eigen::MatrixXd>& transitions);

/// Norms on the sections of an orbit like AdaptedNorms, but separate for two parts of a disturbance. The
/// *slow* part moves no contact: it is a free vibration along flat walls, damped only by the structure. The
/// *fast* part is everything else.
struct SplitNorms {
  /// Norm for each turn's section: the first `fast` rows give the fast part, the others the slow part.
  std::vector<Eigen::MatrixXd> norm;
  std::vector<Eigen::MatrixXd> unit;  ///< inverse of each norm
  Eigen::Index fast = 0;
  /// Contraction of each part by every turn, < 1; in addition, the fast part excites the slow part.
  integrate::exact::tube::Parts contraction;

  Eigen::Index slow() const { return norm.front().rows() - fast; }
};

/// Rows that map a section to what the contacts sense: penetrations, then their rates.
Eigen::MatrixXd seen_by_contacts(const scene::Scene& scene);

/// Norms for the turns `transitions` of an orbit, see adapted_norms. `seen` is seen_by_contacts. A multiplier
/// belongs to the slow part if `seen` maps its eigenvectors to zero, up to rounding, and if it loses less
/// than half in a turn. The slow part is invariant under the turns and has the adapted norm of their
/// restriction to it; the fast part has that of the turns modulo the slow part. Empty where one of the parts
/// is missing or has no norm.
std::optional<SplitNorms> split_norms(const std::vector<Eigen::MatrixXd>& transitions,
                                      const Eigen::MatrixXd& seen);

/// Lengths of both parts of `offset` from section `turn` of the orbit.
integrate::exact::tube::Parts parts_of(const SplitNorms& norms, std::size_t turn,
                                       const Eigen::VectorXd& offset);

/// Test for linear convergence of a transient to its orbit. The test counts successive returns that the
/// derivative of the return map predicts well: with an error of at most a tenth of what a return gains. This
/// error is of second order in the distance and shrinks on the way. Once several returns in a row pass and
/// half of the distance is gone, the transient converges to the orbit. Near a fold or torus bifurcation the
/// orbit attracts very weakly, and the error may stay larger for long: it speeds up the approach, or turns it
/// by an angle that depends on the distance. The predicted point is then far off, although it is equally near
/// to the orbit. In this case each of several returns in a row must gain at least nine tenths of the promised
/// rate, as many as are needed to halve the distance. A transient beyond the unstable orbit or torus of the
/// bifurcation gains nothing.
class LinearConvergenceTest {
 public:
  /// `in_a_row`: number of successive returns (or of their turns) that must be predicted.
  explicit LinearConvergenceTest(int in_a_row) : in_a_row_(in_a_row) {}

  /// Adds a return, or one of its turns. It started at `distance` from the orbit and ended `error` away from
  /// the prediction, in a norm that the derivative contracts at least by `contraction`, 0 < contraction < 1.
  void add_prediction(double error, double distance, double contraction) {
    predicted_ = error <= predicted_within * (1 - contraction) * distance ? predicted_ + 1 : 0;
  }
  /// Adds a return that changed the distance from `before` to `now` in such a norm.
  void add_contraction(double before, double now, double contraction) {
    gained_ = before - now >= gained_at_least * (1 - contraction) * before ? gained_ + 1 : 0;
    halving_ = std::numbers::ln2 / -std::log(contraction);
  }

  /// Whether the test is passed when the distance has fallen from `first` to `distance`.
  bool passed(double distance, double first) const {
    const bool on_its_way = predicted_ >= in_a_row_ || (gained_ > 0 && gained_ >= halving_);
    return on_its_way && distance < followed_down * first;
  }

 private:
  static constexpr double followed_down = 0.5, predicted_within = 0.1, gained_at_least = 0.9;

  int in_a_row_, predicted_ = 0, gained_ = 0;
  double halving_ = 0;
};

/// Largest number of turns (or returns) for which a transient towards an orbit is followed: three times what
/// the norm promises near the orbit, plus some for the start, where the transient is still far away.
struct Patience {
  double start = 0;
  double most = 0;

  /// Limit where the norm promises the required nearness in `promised` turns.
  double turns(double promised) const { return std::min(most, start + times_promised * promised); }
  /// Limit for an approach from the distance `first` to `now` in a norm that every turn contracts at least by
  /// `contraction`. A transient that takes longer approaches something else.
  double turns(double contraction, double first, double now) const {
    return turns(std::log(std::max(1.0, first / now)) / -std::log(contraction));
  }

 private:
  static constexpr double times_promised = 3;
};

/// Criteria for being near an orbit; one of them is enough.
struct Nearness {
  double adapted = 0;  ///< largest distance in the adapted norm of the turn
  double largest = 0;  ///< largest component of the distance, in (clearance, clearance omega)
  /// Half of the first distance with LinearConvergenceTest passed over the turns of three periods.
  bool converges = false;
};

/// Follows a transient turn by turn until it is near the orbit. It starts at `section`, to be compared with
/// the orbit's first section. False when a turn fails, when the distance grows to four times its first value,
/// or when it takes more turns than `patience` allows.
bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, const Patience& patience);

/// Follows a transient like comes_near until both parts of `norms` are within `radii`; distances are in the
/// norm whose unit ball has these radii. Also false after `most_turns`.
bool comes_inside(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                  const SplitNorms& norms, const integrate::exact::tube::Parts& radii, double most_turns);

/// Distance of a section from the orbit's first section in the adapted norm there.
double adapted_distance(std::span<const double> section, const StableOrbit& orbit, const AdaptedNorms& norms);

}  // namespace rubsweep::response::proof
