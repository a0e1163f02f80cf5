#include "rubsweep/numerics/modal_form_cache.hpp"

#include <algorithm>

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
  auto found = std::ranges::find_if(recent_, [&](const Kept& kept) {
    return kept.stiffness.rows() == stiffness.rows() && kept.stiffness == stiffness &&
           kept.damping == damping;
  });
  if (found == recent_.end())
    found = recent_.insert(found, {stiffness, damping, modal_form(stiffness, damping)});
  std::rotate(recent_.begin(), found, found + 1);
  std::size_t bytes = 0, kept = 0;
  for (const Kept& one : recent_) {
    bytes += one.bytes();
    if (kept > 0 && bytes > most_bytes_) break;
    ++kept;
  }
  recent_.erase(recent_.begin() + static_cast<std::ptrdiff_t>(kept), recent_.end());
  return recent_.front().form;
}

}  // namespace rubsweep::numerics
