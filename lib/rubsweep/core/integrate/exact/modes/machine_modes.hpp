#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/integrate/exact/modes/unbalance_responses.hpp"

namespace rubsweep::integrate::exact::modes {

/// The exact flows of the contact modes of a structure with its stops, with saturated friction. They do not
/// depend on speed, unbalance or kick; beside them are the responses to the latest unbalance. Modes are made
/// when first needed; only one thread may use them at a time.
template <int N>
class MachineModes {
 public:
  explicit MachineModes(const scene::Scene& scene);

  /// Whether the modes were made for the structure, stops and constant forces of `scene`.
  bool fits(const scene::Scene& scene) const;

  std::size_t bytes() const;  ///< Approximate memory of the flows of all modes made so far.

  /// Linear mode of a joint contact mode, numbered as by `in_joint_mode`. Null where the mode has no
  /// equilibrium, as in a structure without springs, or when the maximum number of modes with a backward slip
  /// is reached.
  const LinearMode<N>* mode(std::size_t joint);

  /// Change between two of these modes.
  const ModeChange<N>& change(const LinearMode<N>& from, const LinearMode<N>& to);

  /// Responses to an unbalance, shared by successive runs with the same unbalance.
  std::shared_ptr<UnbalanceResponses<N>> responses_to(const Eigen::VectorXcd& acceleration,
                                                      double rate_rad_per_s);

  /// Scaled system with time in seconds.
  const run::ScaledSystem<Eigen::Dynamic>& system() const { return common_.system; }
  const Eigen::MatrixXd& inverse_mass() const { return inverse_mass_; }
  const std::vector<contact::SaturatedFriction>& friction() const { return common_.friction; }

 private:
  std::unique_ptr<LinearMode<N>> make(std::size_t joint);

  scene::Scene scene_;
  CommonToModes common_;
  Eigen::MatrixXd inverse_mass_;
  std::vector<std::unique_ptr<LinearMode<N>>> modes_;  ///< modes whose slips are all forward
  std::vector<bool> made_;
  std::unordered_map<std::size_t, std::unique_ptr<LinearMode<N>>> backward_modes_;
  std::size_t count_ = 0;
  std::shared_ptr<UnbalanceResponses<N>> responses_;  ///< responses to the latest unbalance
  std::map<std::pair<std::size_t, std::size_t>, ModeChange<N>> changes_;  ///< key: indices of both modes
};

extern template class MachineModes<2>;
extern template class MachineModes<4>;
extern template class MachineModes<6>;
extern template class MachineModes<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact::modes
