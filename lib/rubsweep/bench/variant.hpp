#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rubsweep/integrate/options.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::bench {

/// One way of computing a motion, as the tables list it.
struct Variant {
  integrate::Method method = integrate::Method::exact;
  std::optional<integrate::Stepper> stepper;  ///< empty: closed forms alone, no stepper was ever asked
  integrate::ContactHandling contact = integrate::ContactHandling::located;
  std::optional<double> relative_tolerance;  ///< empty with `stepper`
};

/// The steppers that a table is made of: all but `automatic`, which is one of these at each step.
std::span<const integrate::Stepper> all_steppers();

/// The variants of one scene: the exact solver first, then adaptive ones, by stepper, contact handling and
/// tolerance. The exact solver is one line when `turns` revolutions of the scene need closed forms only; else
/// one line for every stepper and tolerance that makes the other turns. Nothing where it does not apply.
std::vector<Variant> variants_of(const scene::Scene& scene, const integrate::SolverOptions& base, int turns,
                                 std::span<const integrate::Stepper> steppers,
                                 std::span<const double> relative_tolerances);

/// `base` with what the variant says.
integrate::SolverOptions options_of(const Variant& variant, integrate::SolverOptions base);

/// Names as the configuration has them.
std::string_view to_string(integrate::Method method);
std::string_view to_string(integrate::Stepper stepper);
std::string_view to_string(integrate::ContactHandling contact);

}  // namespace rubsweep::bench
