#include "rubsweep/maps/sweep/footprint.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"

namespace rubsweep::sweep {
namespace {

constexpr std::size_t program_bytes = 12'000'000, mpi_bytes = 30'000'000, thread_bytes = 1'000'000,
                      sample_bytes = 192, cell_bytes = 24, row_bytes = 3 * 340;

/// Whether a number under this key leaves the flows of a machine unchanged.
bool changes_no_flow(std::string_view key) {
  constexpr std::array<std::string_view, 4> parts{"kick.", "start.", "solver.", "response."};
  return std::ranges::any_of(parts, [key](std::string_view part) { return key.starts_with(part); });
}

bool changes_no_flow(const KeyAxis& axis) {
  return std::ranges::all_of(axis.keys, [](const std::string& key) { return changes_no_flow(key); });
}

/// Whether a cell tries numbers (thresholds, basins) that give each run its own machine and flows.
bool varies_machines(const Study& study) {
  if (study.threshold && !changes_no_flow(study.threshold->axis)) return true;
  return study.basin && !std::ranges::all_of(study.basin->over, [](const DrawnKey& drawn) {
           return changes_no_flow(drawn.key);
         });
}

/// Upper bound in bytes of the flows that one thread keeps in its cache for this study.
std::size_t flow_bytes(const Study& study, const structure::Assembly& assembly) {
  const bool by_speed =
      assembly.gyroscopic.size() > 0 || assembly.circulatory.size() > 0 || !assembly.tables.empty();
  const std::size_t bytes = integrate::exact::modes::most_bytes_of_modes(
      assembly.system.coordinates(),
      std::min(study.machine.stops.size(), integrate::exact::modes::most_exact_contacts));
  std::size_t machines = by_speed ? study.grid.speed_hz.size() : 1;
  for (const KeyAxis& axis : study.grid.axes) {
    if (!changes_no_flow(axis)) machines *= axis.values.size();
  }
  // Each cell may need other secants, and therefore other flows.
  if (study.hertz_iterations > 0)
    machines = cell_count(study.grid) * (1 + static_cast<std::size_t>(study.hertz_iterations));
  constexpr std::size_t most = integrate::exact::modes::most_bytes_of_a_mode_cache;
  return varies_machines(study) || machines > most / bytes ? most : machines * bytes;
}

std::size_t memory_bytes(const Study& study, const Workers& workers, std::size_t flows_of_a_thread) {
  const std::size_t samples = static_cast<std::size_t>(study.response.window_revolutions) *
                              static_cast<std::size_t>(study.response.samples_per_revolution);
  return program_bytes + (workers.ranks > 0 ? mpi_bytes : 0) +
         static_cast<std::size_t>(workers.threads) *
             (thread_bytes + sample_bytes * samples + flows_of_a_thread) +
         cell_bytes * cell_count(study.grid);
}

}  // namespace

Footprint footprint(const Study& study, const Workers& workers) {
  return footprint(study, scene::prepare_machine(study.machine), workers);
}

Footprint footprint(const Study& study, const scene::PreparedMachine& prepared, const Workers& workers) {
  return {memory_bytes(study, workers, flow_bytes(study, prepared.assembly)),
          row_bytes * cell_count(study.grid)};
}

std::size_t most_memory_bytes(const Study& study, const Workers& workers) {
  return memory_bytes(study, workers, integrate::exact::modes::most_bytes_of_a_mode_cache);
}

std::vector<std::size_t> take_pilot_cells(std::vector<std::size_t>& cells, std::size_t count) {
  std::vector<std::size_t> pilots, others;
  const std::size_t wanted = std::min(count, cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // Takes the middle cell of each of `wanted` equal stretches.
    const bool chosen =
        pilots.size() < wanted && i == ((2 * pilots.size() + 1) * cells.size()) / (2 * wanted);
    (chosen ? pilots : others).push_back(cells[i]);
  }
  cells = std::move(others);
  return pilots;
}

}  // namespace rubsweep::sweep
