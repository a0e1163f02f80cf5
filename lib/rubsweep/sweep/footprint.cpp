#include "rubsweep/sweep/footprint.hpp"

#include <algorithm>
#include <utility>

namespace rubsweep::sweep {
namespace {

constexpr std::size_t program_bytes = 12'000'000, mpi_bytes = 30'000'000, thread_bytes = 1'000'000,
                      sample_bytes = 192, cell_bytes = 24, row_bytes = 3 * 340;

}  // namespace

Footprint footprint(const Study& study, const Workers& workers) {
  const std::size_t cells = cell_count(study.grid);
  const std::size_t samples = static_cast<std::size_t>(study.response.window_revolutions) *
                              static_cast<std::size_t>(study.response.samples_per_revolution);
  return {program_bytes + (workers.ranks > 0 ? mpi_bytes : 0) +
              static_cast<std::size_t>(workers.threads) * (thread_bytes + sample_bytes * samples) +
              cell_bytes * cells,
          row_bytes * cells};
}

std::vector<std::size_t> take_pilot_cells(std::vector<std::size_t>& cells, std::size_t count) {
  std::vector<std::size_t> pilots, others;
  const std::size_t wanted = std::min(count, cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // The middle one of each of `wanted` stretches.
    const bool chosen =
        pilots.size() < wanted && i == ((2 * pilots.size() + 1) * cells.size()) / (2 * wanted);
    (chosen ? pilots : others).push_back(cells[i]);
  }
  cells = std::move(others);
  return pilots;
}

}  // namespace rubsweep::sweep
