#include "rubsweep/core/response/proof/split_norms.hpp"

#include <cmath>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/least_norm.hpp"
#include "rubsweep/core/response/proof/adapted_norm.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Largest projection onto the contacts, as a share of the eigenvector's length, that counts as unseen. More
/// than rounding would harm only the ball, whose tubes count everything.
constexpr double unseen = 1e-8;
constexpr double slow_from = 0.5;  ///< of a disturbance left after a turn

/// A basis of the eigenvectors that are slow and that no contact sees.
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

/// Orthonormal columns: the first are across the columns of `basis`, the last ones span them.
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

}  // namespace

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

}  // namespace rubsweep::response::proof
