#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/numerics/modal_form.hpp"

namespace rubsweep::integrate::exact::modes {

/// Motion of the free vibration z of a mode, from which the rate and the bounds of a row on it follow.
template <int N>
struct FreeVibration {
  typename ExactTypes<N>::Flow basis;  ///< maps z to (u, u')
  std::optional<numerics::ModalForm> form;
  std::optional<numerics::FlowBound> flow_bound;  ///< if there is no modal form
};

/// Adds the linear functions of its motion to a mode whose flow is known: guards of contacts, forces and
/// sliding speeds of touching contacts, and casings. `backward` as for make_linear_mode.
template <int N>
void add_views(const CommonToModes& common, const std::vector<bool>& backward,
               const FreeVibration<N>& vibration, LinearMode<N>& mode);

}  // namespace rubsweep::integrate::exact::modes
