#include "rubsweep/maps/sweep/hertz_secant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/contact/hertz_line.hpp"

namespace rubsweep::sweep {
namespace {

bool has_hertz(const model::Stop& stop) { return stop.by_hertz_secant(); }

/// Whether the secants of both machines agree within contact::hertz_secant_tolerance at every stop.
bool fits(const model::Machine& used, const model::Machine& asked) {
  for (std::size_t i = 0; i < used.stops.size(); ++i) {
    const double ratio = asked.stops[i].stiffness_n_per_m / used.stops[i].stiffness_n_per_m;
    constexpr double most = 1 + contact::hertz_secant_tolerance;
    if (ratio > most || ratio < 1 / most) return false;
  }
  return true;
}

/// Describes the secants by the force at the stop with the smallest design force. From this force the secants
/// of all other stops can be computed, because forces below the design force of a stop do not change its
/// secant.
HertzSecant secant_of(const model::Machine& original, const model::Machine& used, int iterations) {
  std::optional<std::size_t> lowest;
  for (std::size_t i = 0; i < original.stops.size(); ++i) {
    const auto& hertz = original.stops[i].hertz;
    if (has_hertz(original.stops[i]) &&
        (!lowest || hertz->design_force_n < original.stops[*lowest].hertz->design_force_n))
      lowest = i;
  }
  const model::Stop& stop = used.stops[lowest.value()];
  return {iterations, stop.hertz->design_force_n, stop.stiffness_n_per_m};
}

}  // namespace

bool takes_secants_anew(const Study& study) {
  return study.hertz_iterations > 0 && std::ranges::any_of(study.machine.stops, has_hertz);
}

std::optional<model::Machine> with_secant_at(const model::Machine& machine, double force_n) {
  model::Machine changed = machine;
  for (model::Stop& stop : changed.stops) {
    if (!stop.by_hertz_secant()) continue;
    stop.hertz->design_force_n = std::max(force_n, stop.hertz->design_force_n);
    const auto stiffness = contact::hertz_secant_n_per_m(*stop.hertz, stop.hertz->design_force_n);
    if (!stiffness) return std::nullopt;
    stop.stiffness_n_per_m = *stiffness;
  }
  return changed;
}

scene::PreparedMachine with_secant_of_row(const scene::PreparedMachine& prepared,
                                          std::optional<double> force_n) {
  scene::PreparedMachine changed = prepared;
  if (!force_n) return changed;
  if (auto machine = with_secant_at(prepared.machine, *force_n)) changed.machine = *std::move(machine);
  return changed;
}

Row with_hertz_iterations(const model::Machine& machine, int most,
                          const std::function<Row(const model::Machine&)>& run) {
  Row row = run(machine);
  model::Machine used = machine;
  for (int iterations = 0;; ++iterations) {
    if (row.start) row.hertz = secant_of(machine, used, iterations);
    const double force_n = row.measures ? row.measures->contact.peak_contact_force_n : 0;
    if (!(force_n > 0)) return row;
    std::optional<model::Machine> asked = with_secant_at(machine, force_n);
    if (asked && fits(used, *asked)) return row;
    if (!asked || iterations == most) {
      add_status(row, "beyond_hertz");
      return row;
    }
    used = *std::move(asked);
    row = run(used);
  }
}

}  // namespace rubsweep::sweep
