#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::numerics {

/// Modal form: w' = A w as n decoupled pairs, w = basis z, and (z_j, z_{n+j})' = pairs[j] (z_j, z_{n+j}) for
/// each of them.
struct ModalForm {
  Eigen::MatrixXd basis, inverse;  ///< 2n x 2n
  std::vector<Pair> pairs;         ///< n generators
  /// Largest growth rate. The length of a pair (z_j, z_{n+j}) grows by at most e^{growth t}.
  double growth = 0;
  LongMatrix unrounded_basis{}, unrounded_inverse{};  ///< the same before rounding
};

/// Modal form of u'' = -stiffness u - damping u' with w = (u, u'). Diagonal matrices with positive stiffness
/// keep their coordinates as u and u' / sqrt(stiffness), whose length is an energy and never grows without
/// negative damping, critical damping included. Otherwise the eigenvectors, computed in long double; empty
/// where they are so close to dependent (componentwise condition above 1e4) that the change of basis would
/// cost digits.
std::optional<ModalForm> modal_form(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);
/// The same of matrices that were not rounded.
std::optional<ModalForm> modal_form_of_unrounded(const LongMatrix& stiffness, const LongMatrix& damping);

/// Rate of row . z, again as a row on z.
Eigen::RowVectorXd rate_of_row(const ModalForm& form, const Eigen::RowVectorXd& row);

/// Bound of |row . z(t)| over 0 <= t <= `horizon_s` per size (length) of each pair, in the first half of 2n
/// numbers; the second half is zero.
Eigen::RowVectorXd bound_of_row(const ModalForm& form, const Eigen::RowVectorXd& row, double horizon_s);

}  // namespace rubsweep::numerics
