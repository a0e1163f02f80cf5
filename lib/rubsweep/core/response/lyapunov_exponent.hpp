#pragma once

#include <cstddef>
#include <span>

#include "rubsweep/core/response/motion/motion.hpp"

namespace rubsweep::response {

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
