#include "rubsweep/numerics/modal_form_cache.hpp"

namespace rubsweep::numerics {

std::size_t ModalFormCache::Kept::bytes() const {
  auto numbers = static_cast<std::size_t>(stiffness.size() + damping.size());
  if (!form) return numbers * sizeof(double) + sizeof(Kept);
  numbers += static_cast<std::size_t>(form->basis.size() + form->inverse.size());
  const auto unrounded =
      static_cast<std::size_t>(form->unrounded_basis.size() + form->unrounded_inverse.size());
  return numbers * sizeof(double) + unrounded * sizeof(long double) + sizeof(Kept);
}

const std::optional<ModalForm>& ModalFormCache::form_of(const Eigen::MatrixXd& stiffness,
                                                        const Eigen::MatrixXd& damping) {
  const auto is = [&](const Kept& kept) {
    return kept.stiffness.rows() == stiffness.rows() && kept.stiffness == stiffness &&
           kept.damping == damping;
  };
  if (!recent_.find(is)) recent_.emplace(Kept{stiffness, damping, modal_form(stiffness, damping)});
  recent_.trim([](const Kept& one) { return one.bytes(); });
  return recent_.newest()->form;
}

}  // namespace rubsweep::numerics
