#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/numerics/modal_form.hpp"

namespace rubsweep::integrate::exact::modes {

/// Motion of the free vibration z of a mode, which gives the rate and the bounds of a row on it.
template <int N>
struct FreeVibration {
  typename ExactTypes<N>::Flow basis;  ///< (u, u') of z
  std::optional<numerics::ModalForm> form;
  std::optional<numerics::FlowBound> flow_bound;  ///< where there is no modal form
};

/// Adds to a mode whose flow is made the linear functions of its motion: the guards of its contacts, the
/// forces and sliding speeds of those that touch, the casings. `backward` as of make_linear_mode.
template <int N>
void add_views(const CommonToModes& common, const std::vector<bool>& backward,
               const FreeVibration<N>& vibration, LinearMode<N>& mode);

}  // namespace rubsweep::integrate::exact::modes
