#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/numerics/long_matrix.hpp"
#include "rubsweep/numerics/pair_flow.hpp"
#include "rubsweep/numerics/recently_used.hpp"

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

/// Least-recently-used cache of modal forms: the eigenvectors of a rotor kit take milliseconds in long
/// double, and all cells of one speed ask for the same. Belongs to one thread.
class ModalFormCache {
 public:
  /// Forms are dropped, longest unused first, until they take no more than this; the last one stays.
  explicit ModalFormCache(std::size_t most_bytes = std::size_t{16} << 20) : recent_(most_bytes) {}

  /// As of modal_form; the reference holds until the next call.
  const std::optional<ModalForm>& form_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);

  std::size_t size() const { return recent_.size(); }

 private:
  struct Kept {
    Eigen::MatrixXd stiffness, damping;
    std::optional<ModalForm> form;

    std::size_t bytes() const;
  };

  RecentlyUsed<Kept> recent_;
};

}  // namespace rubsweep::numerics
