#include "bench/variant.hpp"

#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::bench {
namespace {

using integrate::run::ContactHandling;
using integrate::run::Method;
using integrate::run::Stepper;

bool closed_forms_do(const scene::Scene& scene, integrate::run::SolverOptions base, int turns) {
  base.method = Method::exact;
  base.contact = ContactHandling::located;
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, base, modes);
  integrate::run::TurnReport turn;
  for (int k = 0; k < turns; ++k) {
    if (run.advance({}, turn) != integrate::run::Outcome::ok) return false;
  }
  return turn.effort.adaptive_turns == 0 && turn.effort.taylor_turns == 0;
}

}  // namespace

std::vector<Variant> variants_of(const scene::Scene& scene, const integrate::run::SolverOptions& base,
                                 int turns, std::span<const Stepper> steppers,
                                 std::span<const double> relative_tolerances) {
  std::vector<Variant> variants;
  const auto add = [&](Method method, ContactHandling contact) {
    for (const Stepper stepper : steppers) {
      for (const double tolerance : relative_tolerances)
        variants.push_back({method, stepper, contact, tolerance});
    }
  };
  if (integrate::exact::modes::exact_applies(scene)) {
    variants.push_back({Method::exact, {}, ContactHandling::located, {}});
    if (!closed_forms_do(scene, base, turns)) add(Method::exact, ContactHandling::located);
  }
  add(Method::adaptive, ContactHandling::located);
  add(Method::adaptive, ContactHandling::smoothed);
  return variants;
}

integrate::run::SolverOptions options_of(const Variant& variant, integrate::run::SolverOptions base) {
  base.method = variant.method;
  base.contact = variant.contact;
  base.stepper = variant.stepper.value_or(Stepper::automatic);
  if (variant.relative_tolerance) base.relative_tolerance = *variant.relative_tolerance;
  return base;
}

}  // namespace rubsweep::bench
