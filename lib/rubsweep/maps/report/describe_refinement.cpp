#include "rubsweep/maps/report/describe_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubsweep::report {

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

}  // namespace rubsweep::report
