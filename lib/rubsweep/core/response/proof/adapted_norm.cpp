#include "rubsweep/core/response/proof/adapted_norm.hpp"

#include <cmath>

#include "rubsweep/core/numerics/dense/cholesky.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;

/// sum of (A^k)^T Q A^k over all k >= 0, for A with multipliers inside the unit circle.
std::optional<MatrixXd> sum_of_powers(MatrixXd a, MatrixXd q) {
  constexpr int most_doublings = 40;
  for (int i = 0; i < most_doublings; ++i) {
    const MatrixXd further = a.transpose() * q * a;
    if (!further.allFinite()) return std::nullopt;
    q += further;
    if (further.norm() <= 1e-17 * q.norm()) return q;
    a = (a * a).eval();
  }
  return std::nullopt;
}

}  // namespace

std::optional<AdaptedNorms> adapted_norms(const std::vector<MatrixXd>& transitions) {
  const Eigen::Index size = transitions.front().rows();
  const MatrixXd identity = MatrixXd::Identity(size, size);
  MatrixXd monodromy = identity;
  for (const MatrixXd& turn : transitions) monodromy = turn * monodromy;
  const double modulus = numerics::dense::spectral_radius(monodromy);
  if (!(modulus < 1)) return std::nullopt;
  const auto turns = static_cast<double>(transitions.size());
  AdaptedNorms norms;
  norms.contraction = std::pow((1 + modulus) / 2, 1 / turns);

  MatrixXd through = identity, weight = MatrixXd::Zero(size, size);
  for (const MatrixXd& turn : transitions) {
    weight += through.transpose() * through;
    through = turn * through / norms.contraction;
  }
  const auto first = sum_of_powers(through, weight);
  if (!first) return std::nullopt;
  norms.norm.resize(transitions.size());
  MatrixXd square = *first;
  for (std::size_t i = transitions.size(); i-- > 0;) {
    square = identity +
             transitions[i].transpose() * square * transitions[i] / (norms.contraction * norms.contraction);
    const numerics::dense::CholeskyFactors factor(square);
    if (!factor.positive_definite()) return std::nullopt;
    norms.norm[i] = factor.upper();
  }
  return norms;
}

}  // namespace rubsweep::response::proof
