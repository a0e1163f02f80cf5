#include "rubsweep/core/response/proof/approach.hpp"

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;

/// Sum of (A^k)^T Q A^k over all k >= 0, for A with eigenvalues inside the unit circle.
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

using Eigen::Index;
using Eigen::VectorXd;

/// Largest projection onto the contacts, relative to the eigenvector's length, that counts as zero. If
/// such a projection is more than rounding, the ball only becomes smaller, because its tubes take every
/// disturbance into account.
constexpr double unseen = 1e-8;
constexpr double slow_from = 0.5;  ///< least share of a slow disturbance left after a turn

/// Basis of the slow eigenvectors that no contact senses.
MatrixXd slow_directions(const MatrixXd& monodromy, double turns, const MatrixXd& seen) {
  const numerics::dense::Eigenvectors all = numerics::dense::eigenvectors(monodromy);
  MatrixXd basis(monodromy.rows(), 0);
  const auto add = [&basis](const VectorXd& direction) {
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols<1>() = direction;
  };
  for (Index i = 0; i < all.values.size(); ++i) {
    const Eigen::VectorXcd direction = all.vectors.col(i).normalized();
    if (all.values(i).imag() < 0 || std::abs(all.values(i)) < std::pow(slow_from, turns)) continue;
    if (!((seen * direction).norm() <= unseen)) continue;
    add(direction.real());
    if (all.values(i).imag() > 0) add(direction.imag());
  }
  return basis;
}

/// Orthonormal columns: the last ones span the columns of `basis`, the first ones its orthogonal complement.
MatrixXd across_and_along(const MatrixXd& basis) {
  const Index along = basis.cols(), size = basis.rows();
  const MatrixXd whole = numerics::dense::orthonormal_columns(basis, size);
  MatrixXd sorted(size, size);
  sorted << whole.rightCols(size - along), whole.leftCols(along);
  return sorted;
}

MatrixXd block_diagonal(const MatrixXd& first, const MatrixXd& second) {
  MatrixXd both = MatrixXd::Zero(first.rows() + second.rows(), first.cols() + second.cols());
  both.topLeftCorner(first.rows(), first.cols()) = first;
  both.bottomRightCorner(second.rows(), second.cols()) = second;
  return both;
}

MatrixXd inverse_of_upper(const MatrixXd& norm) {
  return norm.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(norm.rows(), norm.cols()));
}

constexpr double farther = 4;
constexpr int predicted_periods = 3;

auto off(std::span<const double> section, const StableOrbit& orbit, std::size_t turn) {
  return Eigen::Map<const VectorXd>(section.data(), static_cast<Eigen::Index>(section.size())) -
         orbit.sections[turn];
}

/// Length of matrix times vector; `product` is memory for it.
double length_of(const MatrixXd& matrix, const VectorXd& vector, VectorXd& product) {
  product.noalias() = matrix.lazyProduct(vector);
  return product.norm();
}

/// Follows a transient until `near(turn of the orbit, offset, size)` is true, where size = `size_of(offset,
/// turn of the orbit)`, for at most `most_turns(first size, size)` turns.
template <class SizeOf, class Near, class MostTurns>
bool follow(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
            const SizeOf& size_of, const Near& near, const MostTurns& most_turns) {
  std::vector<double> now(section.begin(), section.end());
  VectorXd offset = off(now, orbit, 0);
  const double first = size_of(offset, std::size_t{0});
  for (long k = 0;; ++k) {
    const auto at = static_cast<std::size_t>(k % orbit.order);
    offset = off(now, orbit, at);
    const double size = size_of(offset, at);
    if (near(at, offset, size)) return true;
    if (!(size <= farther * first) || static_cast<double>(k) >= most_turns(first, size) ||
        !turn(now, nullptr))
      return false;
  }
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

MatrixXd seen_by_contacts(const scene::Scene& scene) {
  MatrixXd rows(0, scene.structure.coordinates());
  for (const scene::Contact& contact : scene.contacts) {
    const MatrixXd against =
        contact::rows_against(contact.wall, scene::relative_map(scene.structure, contact));
    rows.conservativeResize(rows.rows() + against.rows(), Eigen::NoChange);
    rows.bottomRows(against.rows()) = against;
  }
  return block_diagonal(rows, rows);
}

std::optional<SplitNorms> split_norms(const std::vector<MatrixXd>& transitions, const MatrixXd& seen) {
  const Index size = transitions.front().rows();
  MatrixXd monodromy = MatrixXd::Identity(size, size);
  for (const MatrixXd& turn : transitions) monodromy = turn * monodromy;
  const MatrixXd first = slow_directions(monodromy, static_cast<double>(transitions.size()), seen);
  const Index slow = first.cols(), fast = size - slow;
  if (slow == 0 || fast == 0) return std::nullopt;
  std::vector<MatrixXd> axes{across_and_along(first)};
  for (std::size_t i = 0; i + 1 < transitions.size(); ++i)
    axes.push_back(across_and_along(transitions[i] * axes[i].rightCols(slow)));
  std::vector<MatrixXd> across, along;
  for (std::size_t i = 0; i < transitions.size(); ++i) {
    const MatrixXd turn = axes[(i + 1) % axes.size()].transpose() * transitions[i] * axes[i];
    across.push_back(turn.topLeftCorner(fast, fast));
    along.push_back(turn.bottomRightCorner(slow, slow));
  }
  const auto fast_norms = adapted_norms(across), slow_norms = adapted_norms(along);
  if (!fast_norms || !slow_norms) return std::nullopt;
  SplitNorms norms;
  norms.fast = fast;
  norms.contraction = {fast_norms->contraction, slow_norms->contraction};
  for (std::size_t i = 0; i < transitions.size(); ++i) {
    norms.norm.push_back(block_diagonal(fast_norms->norm[i], slow_norms->norm[i]) * axes[i].transpose());
    norms.unit.push_back(axes[i] * block_diagonal(inverse_of_upper(fast_norms->norm[i]),
                                                  inverse_of_upper(slow_norms->norm[i])));
  }
  return norms;
}

integrate::exact::tube::Parts parts_of(const SplitNorms& norms, std::size_t turn, const VectorXd& offset) {
  const VectorXd x = norms.norm[turn] * offset;
  return {x.head(norms.fast).norm(), x.tail(norms.slow()).norm()};
}

double adapted_distance(std::span<const double> section, const StableOrbit& orbit,
                        const AdaptedNorms& norms) {
  VectorXd product;
  return length_of(norms.norm.front(), off(section, orbit, 0), product);
}

bool comes_near(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                const AdaptedNorms& norms, const Nearness& wanted, const Patience& patience) {
  VectorXd predicted, missed, product;
  const auto size_of = [&](const VectorXd& offset, std::size_t at) {
    return length_of(norms.norm[at], offset, product);
  };
  LinearConvergenceTest convergence(predicted_periods * orbit.order);
  const double of_a_period = std::pow(norms.contraction, orbit.order);
  double first = 0, last = 0, a_period_ago = 0;
  const auto near = [&](std::size_t at, const VectorXd& offset, double size) {
    if (size <= wanted.adapted || offset.cwiseAbs().maxCoeff() <= wanted.largest) return true;
    if (!wanted.converges) return false;
    if (predicted.size() == 0) {
      first = size;
    } else {
      missed = offset - predicted;
      convergence.add_prediction(size_of(missed, at), last, norms.contraction);
      if (at == 0) convergence.add_contraction(a_period_ago, size, of_a_period);
    }
    predicted.noalias() = orbit.transitions[at].lazyProduct(offset);
    last = size;
    if (at == 0) a_period_ago = size;
    return convergence.passed(size, first);
  };
  return follow(turn, section, orbit, size_of, near,
                [&](double from, double size) { return patience.turns(norms.contraction, from, size); });
}

bool comes_inside(const TurnMap& turn, std::span<const double> section, const StableOrbit& orbit,
                  const SplitNorms& norms, const integrate::exact::tube::Parts& radii, double most_turns) {
  VectorXd x(norms.norm.front().rows());
  const auto size_of = [&](const VectorXd& offset, std::size_t at) {
    x.noalias() = norms.norm[at].lazyProduct(offset);
    return std::max(x.head(norms.fast).norm() / radii.fast, x.tail(norms.slow()).norm() / radii.slow);
  };
  const auto near = [](std::size_t, const VectorXd&, double size) { return size <= 1; };
  const auto turns = [most_turns](double, double) { return most_turns; };
  return follow(turn, section, orbit, size_of, near, turns);
}

}  // namespace rubsweep::response::proof
