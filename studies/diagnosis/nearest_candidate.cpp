#include "nearest_candidate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose {

std::pair<std::size_t, double> nearest_candidate(const features::DescribedMotion& seen,
                                                 const inference::DiagnosisProblem& problem,
                                                 const inference::Diagnosis& diagnosis) {
  struct Near {
    double distance = 0, density = 0;
    std::size_t candidate = 0;
  };
  const Eigen::MatrixXd& all = diagnosis.observed.features;
  const Eigen::RowVectorXd middle = all.colwise().mean(),
                           spread = (all.rowwise() - middle).array().square().colwise().mean().sqrt() + 1e-12;
  const Eigen::RowVectorXd here = values_of(seen.features).transpose();
  std::vector<Near> cases;
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const inference::SimulatedCase& one = diagnosis.set.cases[static_cast<std::size_t>(i)];
    const double density = density_of_size(problem, one, diagnosis.observed.size_m(i), seen.size_m);
    if (density > 0)
      cases.push_back(
          {((all.row(i) - here).array() / spread.array()).square().sum(), density, one.candidate});
  }
  constexpr std::size_t most_near = 15;
  const std::size_t near = std::min(most_near, cases.size());
  std::ranges::partial_sort(cases, cases.begin() + static_cast<std::ptrdiff_t>(near), {}, &Near::distance);
  std::vector<double> share(problem.candidates.size(), 0.0);
  double sum = 0;
  for (std::size_t k = 0; k < near; ++k) {
    share[cases[k].candidate] += cases[k].density;
    sum += cases[k].density;
  }
  const auto most = std::ranges::max_element(share);
  return {static_cast<std::size_t>(most - share.begin()), sum > 0 ? *most / sum : 0};
}

}  // namespace rubsweep::diagnose
