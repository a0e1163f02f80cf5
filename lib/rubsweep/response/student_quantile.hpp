#pragma once

#include <cstddef>

namespace rubsweep::response {

/// Half-width of the two-sided 99 % confidence interval of a mean or a slope in units of its standard error:
/// the quantile 0.995 of Student's distribution with so many degrees of freedom, at least 1.
double student_quantile(std::size_t degrees_of_freedom);

}  // namespace rubsweep::response
