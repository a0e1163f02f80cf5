#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::response {

/// Relative error a step of a disturbance of which only the growth counts: no exponent is known as well.
inline constexpr double growth_accuracy = 1e-6;

/// One turn of a motion and of a small disturbance of it: moves the section and returns ln of the factor that
/// the disturbance grew by. Empty: the turn could not be made.
using Growth = std::function<std::optional<double>(std::span<double> section)>;

/// Length of a disturbance that is followed as the difference of two runs, in the units of the state
/// (sections: of the clearance). Between 1e-9 and 1e-4 it moves no exponent of the one-side map visibly
/// (tolerance 1e-8). Far below the tolerance the solver's noise parts the states, not the motion: at
/// tolerance 1e-5 separation 1e-6 shows exponents of +2 where there is rest, separation 1e-5 does not.
inline constexpr double separation = 1e-5;

/// A disturbance of that length with a share of every coordinate: one along a coordinate axis would never
/// leave an invariant subspace, such as the tangential motion at a flat wall.
Eigen::VectorXd first_disturbance(std::size_t states);

/// The disturbance is a tangent vector, moved by the exact derivative of the section where the turn has
/// closed forms: nothing is lost to the distance of two runs, and there is no second run. Turns without
/// closed forms take the difference to a second run that starts at `separation`. G. Benettin, L. Galgani,
/// J.-M. Strelcyn, Phys. Rev. A 14 (1976) 2338: the mean of what is returned tends to the largest exponent.
/// `map` must outlive what is returned.
Growth tangent_growth(proof::SceneMap& map);

/// ln of the factor that a disturbance of unit length has grown by to `direction`, which is given unit length
/// again. One that is shrunk to nothing starts anew.
double take_growth(Eigen::MatrixXd& direction);

/// Exponent from its contributions, one per iteration. The first fifth is dropped (the disturbance turns into
/// the direction of largest growth), the rest makes 8 blocks of equal length with means m_b, each weighted by
/// a Hann window: exponent = mean m, error bar = t s / sqrt(8), s the standard deviation of the m_b, t
/// = 3.4995 (Student, 7 degrees of freedom, 99 %). The method of batch means (A. M. Law, Simulation Modeling
/// and Analysis) with smooth weights: on a torus or a periodic motion the contributions oscillate about their
/// mean, which a flat block cuts off anywhere and a smooth one averages out (S. Das et al., Nonlinearity 30
/// (2017) 4111); the bars of such motions are ten to a hundred times shorter, those of chaotic ones 1.2 times
/// longer. SolverError for fewer than 40 contributions.
motion::Exponent exponent_of(std::span<const double> contributions);

/// Mean of the contributions under the weight exp(-1 / (x (1 - x))), x in (0, 1) along them. Where they come
/// from a quasi-periodic motion it converges faster than any power of their number (S. Das, Y. Saiki,
/// E. Sander, J. A. Yorke, Nonlinearity 30 (2017) 4111): a zero exponent shows after a few hundred turns.
/// Zero for none.
double bump_mean(std::span<const double> contributions);

/// Weighted means of the contributions without their first fifth, and of the two halves of these.
struct BumpMeans {
  double all = 0, first = 0, last = 0;
};
BumpMeans bump_means(std::span<const double> contributions);

/// Half-width of the two-sided 99 % confidence interval of a mean or a slope in units of its standard error:
/// the quantile 0.995 of Student's distribution with so many degrees of freedom, at least 1.
double student_quantile(std::size_t degrees_of_freedom);

}  // namespace rubsweep::response
