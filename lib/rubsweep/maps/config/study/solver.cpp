#include "rubsweep/maps/config/study/solver.hpp"

#include <fmt/format.h>

#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {
namespace {

using integrate::run::ContactHandling;
using integrate::run::Method;
using integrate::run::SolverOptions;
using integrate::run::Stepper;

constexpr auto methods = yaml::words_of<Method>();
constexpr auto contacts = yaml::words_of<ContactHandling>();
constexpr yaml::IntegerRange max_steps{SolverOptions::max_steps_low, 1'000'000'000};

yaml::Words<Stepper> steppers() {
  yaml::Words<Stepper> words;
  for (const auto& row : integrate::adaptive::stepper_table()) {
    words.texts.push_back(row.word);
    words.values.push_back(row.stepper);
  }
  return words;
}

void visit_solver(auto& solver, auto&& visit) {
  visit("method", solver.method, methods);
  visit("stepper", solver.stepper, steppers());
  visit("contact", solver.contact, contacts);
  visit("relative_tolerance", solver.relative_tolerance, SolverOptions::relative_tolerance_range);
  visit("smoothing_m", solver.smoothing_m, SolverOptions::smoothing_range);
  visit("max_steps_per_revolution", solver.max_steps_per_revolution, max_steps);
}

}  // namespace

SolverOptions read_solver(const yaml::Value& value, std::size_t stops) {
  yaml::Section section(value);
  SolverOptions solver;
  visit_solver(solver,
               [&](auto name, auto& field, const auto& allowed) { section.field(name, field, allowed); });
  if (solver.method == Method::exact && solver.contact == ContactHandling::smoothed) {
    section.refuse_together("contact", {"method", "contact"},
                            "'smoothed' is a law that the exact solver does not know",
                            "located, or method adaptive");
  }
  constexpr std::size_t most = integrate::exact::modes::most_exact_contacts;
  if (solver.method == Method::exact && stops > most) {
    section.refuse_together("method", {"method"}, fmt::format("is exact beside {} stops", stops),
                            fmt::format("auto or adaptive, or at most {} stops", most));
  }
  section.refuse_unknown_keys();
  return solver;
}

void print_solver(yaml::Printer& printer, const SolverOptions& solver) {
  printer.open("solver");
  visit_solver(solver, [&](auto name, const auto& field, const auto& allowed) {
    printer.field(name, field, allowed);
  });
  printer.close();
}

}  // namespace rubsweep::config::study
