#include "rubsweep/maps/config/study/solver.hpp"

#include <fmt/format.h>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {

using integrate::run::ContactHandling;
using integrate::run::Method;
using integrate::run::SolverOptions;

SolverOptions read_solver(const yaml::Value& value, std::size_t stops) {
  yaml::Section section(value);
  SolverOptions solver;
  read_fields(section, solver);
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

keys::Form solver_form() { return keys::map_of(keys::keys_of<SolverOptions>()); }

void print_solver(yaml::Printer& printer, const SolverOptions& solver) {
  printer.open("solver");
  print_fields(printer, solver);
  printer.close();
}

}  // namespace rubsweep::config::study
