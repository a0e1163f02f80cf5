#include "rubsweep/maps/report/describe_footprint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

std::string shown(std::size_t bytes) {
  const double value = static_cast<double>(bytes);
  return value < 1e9 ? fmt::format("{:.{}f} MB", std::max(value, 1e5) / 1e6, value < 1e7 ? 1 : 0)
                     : fmt::format("{:.3g} GB", value / 1e9);
}

}  // namespace

std::string describe_footprint(const sweep::Study& study, const sweep::Workers& workers) {
  return describe_footprint(study, scene::prepare_machine(study.machine), workers);
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
  if (sweep::footprint(study, workers).memory_bytes <= bytes) return;
  const bool mpi = workers.ranks > 0;
  throw ConfigError(fmt::format(
      "{}, this machine has {} MB{}, allowed: fewer {}--threads, response.window_revolutions or "
      "response.samples_per_revolution",
      describe_footprint(study, workers), bytes / 1'000'000, mpi ? " for each" : "", mpi ? "ranks, " : ""));
}

}  // namespace rubsweep::report
