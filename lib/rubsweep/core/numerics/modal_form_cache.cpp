#include "rubsweep/core/numerics/modal_form_cache.hpp"

#include "rubsweep/core/numerics/modal_form.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"

namespace rubsweep::numerics {

struct ModalFormCache::Recent {
  struct Kept {
    Eigen::MatrixXd stiffness, damping;
    std::optional<ModalForm> form;

    std::size_t bytes() const;
  };

  RecentlyUsed<Kept> forms;
};

std::size_t ModalFormCache::Recent::Kept::bytes() const {
  auto numbers = static_cast<std::size_t>(stiffness.size() + damping.size());
  if (!form) return numbers * sizeof(double) + sizeof(Kept);
  numbers += static_cast<std::size_t>(form->basis.size() + form->inverse.size());
  const auto unrounded =
      static_cast<std::size_t>(form->unrounded_basis.size() + form->unrounded_inverse.size());
  return numbers * sizeof(double) + unrounded * sizeof(long double) + sizeof(Kept);
}

ModalFormCache::ModalFormCache(std::size_t most_bytes)
    : recent_(new Recent{RecentlyUsed<Recent::Kept>(most_bytes)}) {}

ModalFormCache::ModalFormCache(ModalFormCache&&) noexcept = default;
ModalFormCache& ModalFormCache::operator=(ModalFormCache&&) noexcept = default;
ModalFormCache::~ModalFormCache() = default;

const std::optional<ModalForm>& ModalFormCache::form_of(const Eigen::MatrixXd& stiffness,
                                                        const Eigen::MatrixXd& damping) {
  using Kept = Recent::Kept;
  auto& forms = recent_->forms;
  const auto is = [&](const Kept& kept) {
    return kept.stiffness.rows() == stiffness.rows() && kept.stiffness == stiffness &&
           kept.damping == damping;
  };
  if (!forms.find(is)) forms.emplace(Kept{stiffness, damping, modal_form(stiffness, damping)});
  forms.trim([](const Kept& one) { return one.bytes(); });
  return forms.newest()->form;
}

std::size_t ModalFormCache::size() const { return recent_->forms.size(); }

}  // namespace rubsweep::numerics
