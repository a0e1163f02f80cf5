#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

/// One way of computing a motion: a line of the tables.
struct Variant {
  integrate::run::Method method = integrate::run::Method::exact;
  std::optional<integrate::run::Stepper> stepper;  ///< empty: closed forms and Taylor pieces
  integrate::run::ContactHandling contact = integrate::run::ContactHandling::located;
  std::optional<double> relative_tolerance;  ///< empty where `stepper` is empty
};

/// The variants for one scene: first the exact solver (if it applies), then adaptive ones, by stepper,
/// contact handling and tolerance. The exact solver without a stepper is one variant. Where closed forms do
/// not suffice for `turns` revolutions, one more exact variant follows for every stepper and tolerance that
/// computes the other turns.
std::vector<Variant> variants_of(const scene::Scene& scene, const integrate::run::SolverOptions& base,
                                 int turns, std::span<const integrate::run::Stepper> steppers,
                                 std::span<const double> relative_tolerances);

/// The options `base` with the method, stepper and tolerance of the variant.
integrate::run::SolverOptions options_of(const Variant& variant, integrate::run::SolverOptions base);

}  // namespace rubsweep::bench
