#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::numerics {

/// Modal form of w' = A w: n decoupled pairs, w = basis z, with (z_j, z_{n+j})' = pairs[j] (z_j, z_{n+j}).
struct ModalForm {
  Eigen::MatrixXd basis, inverse;  ///< matrices, 2n x 2n
  std::vector<Pair> pairs;         ///< n generators
  double growth = 0;               ///< Largest growth rate: a pair's length grows at most by e^{growth t}.
  LongMatrix unrounded_basis{}, unrounded_inverse{};  ///< basis and inverse before rounding to double
};

/// Modal form of u'' = -stiffness u - damping u' with w = (u, u'). For diagonal matrices with positive
/// stiffness, the pairs are u and u' / sqrt(stiffness); their length is an energy that never grows without
/// negative damping, even at critical damping. Otherwise the eigenvectors are used, computed in long double.
/// Empty where they are nearly dependent (componentwise condition above 1e4), so that the change of basis
/// would lose digits.
std::optional<ModalForm> modal_form(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);
/// Modal form of matrices in long double.
std::optional<ModalForm> modal_form_of_unrounded(const LongMatrix& stiffness, const LongMatrix& damping);

/// Row on z that gives the time derivative of row . z.
Eigen::RowVectorXd rate_of_row(const ModalForm& form, const Eigen::RowVectorXd& row);

/// Bound of |row . z(t)| over 0 <= t <= `horizon_s`, per initial length of each pair. The first n of the 2n
/// numbers hold the bounds, the others are zero.
Eigen::RowVectorXd bound_of_row(const ModalForm& form, const Eigen::RowVectorXd& row, double horizon_s);

}  // namespace rubsweep::numerics
