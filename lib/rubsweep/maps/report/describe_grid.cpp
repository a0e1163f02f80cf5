#include "rubsweep/maps/report/describe_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

std::string shown(std::size_t bytes) {
  const double value = static_cast<double>(bytes);
  return value < 1e9 ? fmt::format("{:.{}f} MB", std::max(value, 1e5) / 1e6, value < 1e7 ? 1 : 0)
                     : fmt::format("{:.3g} GB", value / 1e9);
}

}  // namespace

void require_plane(const sweep::Grid& grid, std::string_view in) {
  const std::vector<sweep::SweptAxis> swept = sweep::swept_axes(grid);
  if (grid.axes.empty() || swept.size() <= 2) return;
  std::string names;
  for (const sweep::SweptAxis& axis : swept) names += (names.empty() ? "" : ", ") + axis.name;
  throw ConfigError(
      fmt::format("sweep: {} have several values, allowed: two axes with several values in {}", names, in));
}

std::string describe_island_bound(const sweep::Grid& grid) {
  const std::size_t side = sweep::island_bound(grid);
  return sweep::swept_axes(grid).size() < 2
             ? fmt::format("an island of {} cells one after the other", side)
             : fmt::format("an island that holds a square of {} x {} cells", side, side);
}

std::string describe_refinement(const sweep::Grid& grid, std::span<const int> labels) {
  const auto known = static_cast<double>(
      labels.size() - static_cast<std::size_t>(std::ranges::count(labels, sweep::unknown_label)));
  std::string text =
      fmt::format("refined: {} of {} cells computed ({:.2f} %); {} is not missed\n", known, labels.size(),
                  100 * known / static_cast<double>(labels.size()), describe_island_bound(grid));
  if (const auto exponent = sweep::boundary_exponent(grid, labels)) {
    text += fmt::format(
        "boundaries: uncertainty exponent {:.2f} (1: lines; where it is less, more levels gain "
        "less)\n",
        *exponent);
  }
  return text;
}

std::string describe_footprint(const sweep::Study& study, const scene::PreparedMachine& prepared,
                               const sweep::Workers& workers) {
  const sweep::Footprint needed = sweep::footprint(study, prepared, workers);
  const bool mpi = workers.ranks > 0;
  return fmt::format("{} cells on {}{} threads: up to {} of memory{}, {} of disk",
                     sweep::cell_count(study.grid), mpi ? fmt::format("{} ranks of ", workers.ranks) : "",
                     workers.threads, shown(needed.memory_bytes), mpi ? " each" : "",
                     shown(needed.disk_bytes));
}

void refuse_more_memory_than(std::size_t bytes, const sweep::Study& study, const sweep::Workers& workers) {
  if (sweep::most_memory_bytes(study, workers) <= bytes) return;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  if (sweep::footprint(study, prepared, workers).memory_bytes <= bytes) return;
  const bool mpi = workers.ranks > 0;
  throw ConfigError(
      fmt::format("{}, this machine has {} MB{}, allowed: fewer {}--threads, response.window_revolutions or "
                  "response.samples_per_revolution",
                  describe_footprint(study, prepared, workers), bytes / 1'000'000, mpi ? " for each" : "",
                  mpi ? "ranks, " : ""));
}

}  // namespace rubsweep::report
