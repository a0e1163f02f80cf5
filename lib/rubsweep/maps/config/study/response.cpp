#include "rubsweep/maps/config/study/response.hpp"

#include <fmt/format.h>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {

using integrate::run::ContactHandling;
using integrate::run::Method;
using integrate::run::SolverOptions;

namespace {

/// Keys that stand beside robustness: probability alone.
bool is_of_neighbours(std::string_view name) { return name.starts_with("robustness_"); }

void refuse_contradictions(const yaml::Section& section, const response::motion::ResponseOptions& options) {
  if (options.max_revolutions < 2 * options.window_revolutions) {
    section.refuse_together("max_revolutions", {"max_revolutions", "window_revolutions"},
                            fmt::format("{} is less than two windows", options.max_revolutions),
                            fmt::format(">= {} = 2 window_revolutions", 2 * options.window_revolutions));
  }
  if (options.samples_per_revolution < 4 * options.max_order) {
    section.refuse_together("samples_per_revolution", {"samples_per_revolution", "max_order"},
                            fmt::format("{} does not resolve max_order", options.samples_per_revolution),
                            fmt::format(">= {} = 4 max_order", 4 * options.max_order));
  }
  if (2 * options.max_order > options.window_revolutions) {
    section.refuse_together("max_order", {"max_order", "window_revolutions"},
                            fmt::format("{} is more than half a window", options.max_order),
                            fmt::format("<= {} = window_revolutions / 2", options.window_revolutions / 2));
  }
}

}  // namespace

void read_response(const yaml::Value& value, sweep::Study& study) {
  yaml::Section section(value);
  read_fields(section, study.response);
  sweep::Study::visit_fields(study, [&](std::string_view name, auto& field, const auto& key) {
    section.field(name, field, key);
    if (is_of_neighbours(name) && study.robustness != sweep::Robustness::probability && section.find(name))
      section.refuse_together(name, {name}, "says nothing without robustness: probability", "no such key");
  });
  if (section.is_sound()) refuse_contradictions(section, study.response);
  section.refuse_unknown_keys();
}

keys::Form response_form() {
  std::vector<keys::Key> of_study = keys::keys_of<sweep::Study>();
  for (keys::Key& key : of_study) {
    if (is_of_neighbours(key.name)) key.when = {"robustness", {"probability"}};
  }
  return keys::map_of(
      keys::joined({keys::keys_of<response::motion::ResponseOptions>(), std::move(of_study)}));
}

void print_response(yaml::Printer& printer, const sweep::Study& study) {
  printer.open("response");
  print_fields(printer, study.response);
  // Only where they say something, so that the configurations of other maps stay as they are.
  sweep::Study::visit_fields(study, [&](std::string_view name, const auto& field, const auto& key) {
    if (is_of_neighbours(name) && study.robustness != sweep::Robustness::probability) return;
    if (name != "hertz_iterations" || study.hertz_iterations > 0) printer.field(name, field, key);
  });
  printer.close();
}

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
  print_map(printer, "solver", solver);
}

}  // namespace rubsweep::config::study
