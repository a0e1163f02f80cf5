#include "rubsweep/config/solver.hpp"

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
namespace {

using integrate::run::ContactHandling;
using integrate::run::Method;
using integrate::run::SolverOptions;
using integrate::run::Stepper;

constexpr Words<Method, 3> methods{{"auto", "exact", "adaptive"},
                                   {Method::automatic, Method::exact, Method::adaptive}};
constexpr Words<Stepper, 6> steppers{
    {"auto", "dopri5", "cash_karp54", "rkf78", "bulirsch_stoer", "rosenbrock4"},
    {Stepper::automatic, Stepper::dopri5, Stepper::cash_karp54, Stepper::rkf78, Stepper::bulirsch_stoer,
     Stepper::rosenbrock4}};
constexpr Words<ContactHandling, 2> contacts{{"located", "smoothed"},
                                             {ContactHandling::located, ContactHandling::smoothed}};
constexpr IntegerRange max_steps{SolverOptions::max_steps_low, 1'000'000'000};

void visit_fields(auto& solver, auto&& visit) {
  visit("method", solver.method, methods);
  visit("stepper", solver.stepper, steppers);
  visit("contact", solver.contact, contacts);
  visit("relative_tolerance", solver.relative_tolerance, SolverOptions::relative_tolerance_range);
  visit("smoothing_m", solver.smoothing_m, SolverOptions::smoothing_range);
  visit("max_steps_per_revolution", solver.max_steps_per_revolution, max_steps);
}

}  // namespace

SolverOptions read_solver(const Value& value) {
  Section section(value);
  SolverOptions solver;
  visit_fields(solver,
               [&](auto name, auto& field, const auto& allowed) { section.field(name, field, allowed); });
  if (solver.method == Method::exact && solver.contact == ContactHandling::smoothed) {
    section.refuse_together("contact", {"method", "contact"},
                            "'smoothed' is a law that the exact solver does not know",
                            "located, or method adaptive");
  }
  section.refuse_unknown_keys();
  return solver;
}

void print_solver(Printer& printer, const SolverOptions& solver) {
  printer.open("solver");
  visit_fields(solver, [&](auto name, const auto& field, const auto& allowed) {
    printer.field(name, field, allowed);
  });
  printer.close();
}

}  // namespace rubsweep::config
