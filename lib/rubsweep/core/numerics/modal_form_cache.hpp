#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>

namespace rubsweep::numerics {

struct ModalForm;

/// Least-recently-used cache of modal forms. The eigenvectors of a rotor kit take milliseconds in long
/// double, and all cells of one speed need the same ones. Belongs to one thread.
class ModalFormCache {
 public:
  /// Above `most_bytes` the cache drops the forms that were unused for longest, but it always keeps the
  /// latest form.
  explicit ModalFormCache(std::size_t most_bytes = std::size_t{16} << 20);
  ModalFormCache(ModalFormCache&&) noexcept;
  ModalFormCache& operator=(ModalFormCache&&) noexcept;
  ~ModalFormCache();

  /// Result of modal_form; the reference is valid until the next call.
  const std::optional<ModalForm>& form_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);

  std::size_t size() const;

 private:
  struct Recent;

  std::unique_ptr<Recent> recent_;
};

}  // namespace rubsweep::numerics
