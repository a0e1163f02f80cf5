#include "rubsweep/maps/config/study/response.hpp"

#include <fmt/format.h>

#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {
namespace {

// The largest window holds 4096 x 4096 samples, 256 MiB for each thread.
constexpr yaml::IntegerRange revolutions{2, 10'000'000};
constexpr yaml::IntegerRange samples{4, 4096, true};
constexpr yaml::IntegerRange window{2, 4096};
constexpr yaml::IntegerRange order{1, 1024};
constexpr yaml::IntegerRange hertz_iterations{0, 20};

constexpr yaml::Words<bool, 2> on_off{{"off", "on"}, {false, true}};
constexpr yaml::Words<sweep::Robustness, 3> switches{
    {"off", "on", "probability"},
    {sweep::Robustness::off, sweep::Robustness::on, sweep::Robustness::probability}};

void visit_response(auto& study, auto&& visit) {
  auto& response = study.response;
  visit("max_revolutions", response.max_revolutions, revolutions);
  visit("samples_per_revolution", response.samples_per_revolution, samples);
  visit("window_revolutions", response.window_revolutions, window);
  visit("max_order", response.max_order, order);
  visit("floquet_proof", response.floquet_proof, on_off);
  visit("robustness", study.robustness, switches);
}

// Only with robustness: probability, so that the configurations of other maps stay as they are.
void visit_neighbours(auto& neighbours, auto&& visit) {
  constexpr yaml::IntegerRange counts{2, 1000, true};
  constexpr model::Range parts{.low = 0, .high = 1, .low_open = true, .high_open = true};
  visit("robustness_neighbours", neighbours.count, counts);
  visit("robustness_part", neighbours.part, parts);
}

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
  visit_response(study,
                 [&](auto name, auto& field, const auto& allowed) { section.field(name, field, allowed); });
  visit_neighbours(study.neighbours, [&](auto name, auto& field, const auto& allowed) {
    section.field(name, field, allowed);
    if (study.robustness != sweep::Robustness::probability && section.find(name))
      section.refuse_together(name, {name}, "says nothing without robustness: probability", "no such key");
  });
  section.field("hertz_iterations", study.hertz_iterations, hertz_iterations);
  if (section.is_sound()) refuse_contradictions(section, study.response);
  section.refuse_unknown_keys();
}

void print_response(yaml::Printer& printer, const sweep::Study& study) {
  printer.open("response");
  visit_response(
      study, [&](auto name, const auto& field, const auto& allowed) { printer.field(name, field, allowed); });
  if (study.robustness == sweep::Robustness::probability) {
    visit_neighbours(study.neighbours, [&](auto name, const auto& field, const auto& allowed) {
      printer.field(name, field, allowed);
    });
  }
  // Only where it is not the default, for the same reason.
  if (study.hertz_iterations > 0) printer.integer("hertz_iterations", study.hertz_iterations);
  printer.close();
}

}  // namespace rubsweep::config::study
