#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "rubsweep/numerics/modal_form.hpp"
#include "rubsweep/numerics/recently_used.hpp"

namespace rubsweep::numerics {

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
