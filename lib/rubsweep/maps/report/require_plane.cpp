#include "rubsweep/maps/report/require_plane.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::report {

void require_plane(const sweep::Grid& grid, std::string_view in) {
  const std::vector<sweep::SweptAxis> swept = sweep::swept_axes(grid);
  if (grid.axes.empty() || swept.size() <= 2) return;
  std::string names;
  for (const sweep::SweptAxis& axis : swept) names += (names.empty() ? "" : ", ") + axis.name;
  throw ConfigError(
      fmt::format("sweep: {} have several values, allowed: two axes with several values in {}", names, in));
}

}  // namespace rubsweep::report
