#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::response {

/// Relative error per step allowed in the growth of a disturbance: no exponent is known more precisely.
inline constexpr double growth_accuracy = 1e-6;

/// Moves a section and a small disturbance of it by one turn; returns ln of the disturbance's growth factor.
/// Empty: the turn could not be computed.
using Growth = std::function<std::optional<double>(std::span<double> section)>;

/// Length of a disturbance that is followed as the difference of two runs, in units of the state (sections:
/// of the clearance). Between 1e-9 and 1e-4 its effect on the exponents of the one-side map is invisible
/// (tolerance 1e-8). If it is far below the solver's tolerance, the noise of the solver separates the states,
/// not the motion. With tolerance 1e-5, separation 1e-6 gives exponents of +2 for a rotor at rest, separation
/// 1e-5 does not.
inline constexpr double separation = 1e-5;

/// A disturbance of length `separation` with a part of every coordinate. A disturbance along a coordinate
/// axis would never leave an invariant subspace, such as the tangential motion at a flat wall.
Eigen::VectorXd first_disturbance(std::size_t states);

/// Growth of a disturbance. Where the turn has closed forms it is a tangent vector, moved by the exact
/// derivative of the section: no accuracy is lost to a finite distance, and no second run is needed. Other
/// turns use the difference to a second run that starts at `separation`. The mean of the returned values
/// tends to the largest exponent (G. Benettin, L. Galgani, J.-M. Strelcyn, Phys. Rev. A 14 (1976) 2338).
/// `map` must outlive the result.
Growth tangent_growth(proof::SceneMap& map);

/// Returns ln of the length of `direction` after a turn that began with unit length, and normalises
/// `direction`. A disturbance that has shrunk to nothing starts anew.
double take_growth(Eigen::MatrixXd& direction);

/// Exponent from its contributions, one per iteration. The first fifth is dropped, in which the disturbance
/// turns into the direction of largest growth. The others form 8 blocks of equal length with means m_b under
/// a Hann window: exponent = mean m, error bar = t s / sqrt(8), s the standard deviation of the m_b, t =
/// 3.4995 (Student, 7 degrees of freedom, 99 %). This is the method of batch means (A. M. Law, Simulation
/// Modeling and Analysis) with smooth weights. On a torus or a periodic motion the contributions oscillate
/// about their mean; a smooth weight averages these oscillations out (S. Das et al., Nonlinearity 30 (2017)
/// 4111). Error bars of such motions are ten to a hundred times shorter than with flat blocks, those of
/// chaotic motions 1.2 times longer. SolverError for fewer than 40 contributions.
motion::Exponent exponent_of(std::span<const double> contributions);

/// Mean of the contributions with the weight exp(-1 / (x (1 - x))), x running from 0 to 1 along them. For a
/// quasi-periodic motion this mean converges faster than any power of the number of contributions (S. Das, Y.
/// Saiki, E. Sander, J. A. Yorke, Nonlinearity 30 (2017) 4111), so that a zero exponent shows after a few
/// hundred turns. Zero without contributions.
double bump_mean(std::span<const double> contributions);

/// Weighted means of the contributions without their first fifth: over all of them, and over each half.
struct BumpMeans {
  double all = 0, first = 0, last = 0;
};
BumpMeans bump_means(std::span<const double> contributions);

/// Quantile 0.995 of Student's distribution with at least 1 degree of freedom. It is the half-width of the
/// two-sided 99 % confidence interval of a mean or a slope, in units of its standard error.
double student_quantile(std::size_t degrees_of_freedom);

}  // namespace rubsweep::response
