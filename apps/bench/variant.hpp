#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

/// One way of computing a motion, as the tables list it.
struct Variant {
  integrate::run::Method method = integrate::run::Method::exact;
  std::optional<integrate::run::Stepper> stepper;  ///< empty: closed forms and Taylor pieces
  integrate::run::ContactHandling contact = integrate::run::ContactHandling::located;
  std::optional<double> relative_tolerance;  ///< empty with `stepper`
};

/// The variants of one scene: the exact solver first, then adaptive ones, by stepper, contact handling and
/// tolerance. The exact solver by itself is one line; where `turns` revolutions of the scene need more than
/// closed forms, one line for every stepper and tolerance that makes the other turns follows. Nothing where
/// it does not apply.
std::vector<Variant> variants_of(const scene::Scene& scene, const integrate::run::SolverOptions& base,
                                 int turns, std::span<const integrate::run::Stepper> steppers,
                                 std::span<const double> relative_tolerances);

/// Options `base` with those of the variant.
integrate::run::SolverOptions options_of(const Variant& variant, integrate::run::SolverOptions base);

}  // namespace rubsweep::bench
