#include "rubsweep/fit/fit_problem.hpp"

#include <cstddef>

namespace rubsweep::fit {

double value_named(const MachineFit& problem, const Eigen::VectorXd& values, const char* name,
                   double otherwise) {
  for (std::size_t i = 0; i < problem.parameters.size(); ++i)
    if (problem.parameters[i].name == name) return values(static_cast<Eigen::Index>(i));
  return otherwise;
}

}  // namespace rubsweep::fit
