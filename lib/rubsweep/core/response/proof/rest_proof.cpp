#include "rubsweep/core/response/proof/rest_proof.hpp"

#include <algorithm>
#include <optional>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/modal_form.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::response::proof {
RestProof::RestProof(const scene::Cell& cell) {
  numerics::ModalFormCache forms;
  *this = RestProof(cell, forms);
}

RestProof::RestProof(const scene::Cell& cell, numerics::ModalFormCache& forms) {
  const scene::Scene& scene = cell.scene;
  const auto system = integrate::run::scale<Eigen::Dynamic>(scene);
  const std::optional<numerics::ModalForm>& form = forms.form_of(system.stiffness, system.damping);
  // A growth of the modal form may be rounding: for an undamped mode its sign is random.
  grows_ = (!form || form->growth > 0) && structure::grows(scene.structure);
  // At a whirl ratio of exactly 1, rounding must not decide.
  if (cell.start != scene::Start::quiet) return;
  // With torsion the free vibration is not linear.
  if (!form || grows_ || !scene.impulses.empty() || scene.twist) return;
  usable_ = true;
  to_modes_ = form->inverse;

  const double length = scene.length_scale_m;
  const Eigen::Index n = scene.structure.coordinates();
  quiet_.resize(2 * n);
  quiet_ << cell.quiet.displacement(0) / length, cell.quiet.velocity(0) / length;
  for (const scene::Contact& contact : scene.contacts) {
    const auto [mean, amplitude] = scene::quiet_penetration(cell.quiet, scene.structure, contact);
    const Eigen::MatrixXd seen =
        contact::rows_against(contact.wall, scene::relative_map(scene.structure, contact));
    const Eigen::VectorXd by_column = (seen * form->basis.topRows(n)).colwise().squaredNorm().transpose();
    bounds_.push_back({(mean + amplitude) / length, (by_column.head(n) + by_column.tail(n)).cwiseSqrt()});
  }
}

bool RestProof::proves(std::span<const double> section) {
  if (!usable_) return false;
  vibration_ =
      Eigen::Map<const Eigen::VectorXd>(section.data(), static_cast<Eigen::Index>(section.size())) - quiet_;
  modes_.noalias() = to_modes_ * vibration_;
  const Eigen::Index n = modes_.size() / 2;
  lengths_ = (modes_.head(n).cwiseAbs2() + modes_.tail(n).cwiseAbs2()).cwiseSqrt();
  return std::all_of(bounds_.begin(), bounds_.end(), [&](const Bound& bound) {
    return bound.quiet_penetration + bound.pair_weight.dot(lengths_) < 0;
  });
}

}  // namespace rubsweep::response::proof
