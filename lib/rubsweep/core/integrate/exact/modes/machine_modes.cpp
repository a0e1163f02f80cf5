#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

/// Limit equal to the number of modes of six stops whose slips are all forward.
constexpr std::size_t most_backward_modes = 4096;

bool same(const scene::Contact& a, const scene::Contact& b) {
  const auto friction_a = contact::saturated_friction(a.friction),
             friction_b = contact::saturated_friction(b.friction);
  return a.rotor_point == b.rotor_point && a.casing_point == b.casing_point &&
         contact::same(a.wall, b.wall) && a.clearance_m == b.clearance_m &&
         a.stiffness_n_per_m == b.stiffness_n_per_m && a.damping_ns_per_m == b.damping_ns_per_m &&
         friction_a.has_value() == friction_b.has_value() &&
         (!friction_a || (friction_a->coefficient == friction_b->coefficient &&
                          friction_a->above_m_per_s == friction_b->above_m_per_s));
}

bool same(const structure::LinearSystem& a, const structure::LinearSystem& b) {
  if (a.coordinates() != b.coordinates() || a.points.size() != b.points.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    if (a.points[i].map != b.points[i].map) return false;
  }
  return a.mass == b.mass && a.damping == b.damping && a.stiffness == b.stiffness;
}

}  // namespace

template <int N>
MachineModes<N>::MachineModes(const scene::Scene& scene)
    : scene_(scene),
      common_{run::scale<Eigen::Dynamic>(scene, run::state_scale(scene).in_seconds()), {}, {}} {
  const Eigen::Index n = system().coordinates();
  if (N != Eigen::Dynamic && n != N) throw SolverError("MachineModes: wrong coordinate count");
  if (n > most_exact_coordinates) throw SolverError("MachineModes: too many coordinates");
  if (scene.contacts.size() > most_exact_contacts) throw SolverError("MachineModes: too many contacts");
  inverse_mass_ = scene.structure.mass.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  for (const scene::Contact& c : scene.contacts) {
    // Friction without a saturated value occurs only while the contact is open.
    common_.friction.push_back(
        contact::saturated_friction(c.friction).value_or(contact::SaturatedFriction{}));
  }
  common_.open_form = numerics::modal_form(system().stiffness, system().damping);
  modes_.resize(std::size_t{1} << (2 * scene.contacts.size()));
  made_.resize(modes_.size());
}

template <int N>
bool MachineModes<N>::fits(const scene::Scene& scene) const {
  if (scene.contacts.size() != scene_.contacts.size() || scene.length_scale_m != scene_.length_scale_m)
    return false;
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    if (!same(scene.contacts[i], scene_.contacts[i])) return false;
  }
  return same(scene.structure, scene_.structure) && scene.constant_n == scene_.constant_n;
}

template <int N>
std::size_t MachineModes<N>::bytes() const {
  const auto states = static_cast<std::size_t>(2 * system().coordinates());
  std::size_t numbers = modes_.size();
  const auto count = [&](const std::unique_ptr<LinearMode<N>>& mode) {
    if (!mode) return;
    const std::size_t matrices = 3 + mode->steps.size(), columns = 4 * mode->pair_steps.size();
    numbers += static_cast<std::size_t>(5 * mode->unrounded.basis.size());
    numbers += states * (states * matrices + columns + numerics::series_rows * mode->guards.size());
  };
  for (const auto& mode : modes_) count(mode);
  for (const auto& [joint, mode] : backward_modes_) count(mode);
  numbers += changes_.size() * states * (states + 1);
  if (responses_) {
    numbers += responses_->modes.size() * sizeof(responses_->modes[0]) / sizeof(double);
    for (const auto& ways : responses_->transitions)
      numbers += ways.size() * sizeof(ways[0]) / sizeof(double);
  }
  return numbers * sizeof(double);
}

template <int N>
const LinearMode<N>* MachineModes<N>::mode(std::size_t joint) {
  if (joint >= modes_.size()) {
    const auto found = backward_modes_.find(joint);
    if (found != backward_modes_.end()) return found->second.get();
    if (backward_modes_.size() >= most_backward_modes) return nullptr;
    return (backward_modes_[joint] = make(joint)).get();
  }
  if (!made_[joint]) {
    modes_[joint] = make(joint);
    made_[joint] = true;
  }
  return modes_[joint].get();
}

template <int N>
std::unique_ptr<LinearMode<N>> MachineModes<N>::make(std::size_t joint) {
  const std::size_t contacts = scene_.contacts.size();
  std::vector<contact::Mode> modes;
  std::vector<bool> backward;
  for (std::size_t i = 0; i < contacts; ++i) {
    modes.push_back(mode_in_joint_mode(joint, i));
    backward.push_back((joint & backward_in_joint_mode(i, contacts)) != 0);
  }
  auto mode = make_linear_mode<N>(common_, modes, backward);
  if (mode) mode->index = count_++;
  return mode;
}

template <int N>
const ModeChange<N>& MachineModes<N>::change(const LinearMode<N>& from, const LinearMode<N>& to) {
  const auto [place, added] = changes_.try_emplace({from.index, to.index});
  if (added) place->second = make_mode_change(from, to);
  return place->second;
}

template <int N>
std::shared_ptr<UnbalanceResponses<N>> MachineModes<N>::responses_to(const Eigen::VectorXcd& acceleration,
                                                                     double rate_rad_per_s) {
  if (!responses_ || responses_->rate_rad_per_s != rate_rad_per_s || responses_->acceleration != acceleration)
    responses_ = std::make_shared<UnbalanceResponses<N>>(UnbalanceResponses<N>{acceleration, rate_rad_per_s});
  return responses_;
}

std::size_t most_bytes_of_modes(Eigen::Index coordinates, std::size_t contacts) {
  const auto states = static_cast<std::size_t>(2 * coordinates);
  const std::size_t guards = 2 * contacts, matrices = 3 + numerics::exact_step_count;
  const std::size_t numbers = 1 + states * (states * matrices + numerics::series_rows * guards);
  std::size_t forward = 1, both = 1;  // friction in one direction only, or in both
  for (std::size_t i = 0; i < contacts; ++i) {
    forward *= contact::mode_count;
    both *= 2 * contact::mode_count - 1;
  }
  return std::min(both, forward + most_backward_modes) * numbers * sizeof(double);
}

bool exact_applies(const scene::Scene& scene) {
  const bool known = std::ranges::all_of(scene.contacts, [](const scene::Contact& contact) {
    return !contact.law && (contact::linear(contact.wall) || contact::annular(contact.wall));
  });
  return known && !scene.twist && scene.contacts.size() <= most_exact_contacts &&
         scene.structure.coordinates() <= most_exact_coordinates;
}

template class MachineModes<2>;
template class MachineModes<4>;
template class MachineModes<6>;
template class MachineModes<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact::modes
