#include "rubsweep/analysis/page/boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_cells.hpp"

namespace rubsweep::page {
namespace {

/// The first column that is called `name`, or that begins with it.
std::optional<std::size_t> column_called(const batch::CsvReader& file, std::string_view name,
                                         bool or_begins = false) {
  const auto found = std::find_if(file.header().begin(), file.header().end(), [&](const std::string& header) {
    return header == name || (or_begins && header.starts_with(name));
  });
  if (found == file.header().end()) return std::nullopt;
  return static_cast<std::size_t>(found - file.header().begin());
}

std::size_t unbalance_column(const batch::CsvReader& file, std::string_view measure) {
  if (const auto exact = column_called(file, measure)) return *exact;
  const auto other = column_called(file, "unbalance", true);
  if (other) return *other;
  throw IoError(fmt::format("{}: no column {} or unbalance", file.path().string(), measure));
}

}  // namespace

std::vector<Boundary> read_boundaries(const std::filesystem::path& path, std::string_view measure,
                                      std::string_view digest) {
  if (!std::filesystem::exists(path)) return {};
  batch::CsvReader file(path);
  const std::string of_map = report::comment_after(file, "digest ");
  if (!of_map.empty() && of_map != digest) return {};
  const std::size_t speed = file.column("speed_hz"), unbalance = unbalance_column(file, measure);
  const auto family = column_called(file, "family"), kind = column_called(file, "kind");
  std::vector<Boundary> boundaries;
  for (bool ended = true; file.next();) {
    const double x = file.number(speed), y = file.number(unbalance);
    const Boundary here{family ? file.cells()[*family] : "", kind ? file.cells()[*kind] : "", {}};
    if (!std::isfinite(x) || !std::isfinite(y)) {
      ended = true;
      continue;
    }
    if (ended || boundaries.back().family != here.family || boundaries.back().kind != here.kind)
      boundaries.push_back(here);
    boundaries.back().points.push_back({x, y});
    ended = false;
  }
  return boundaries;
}

}  // namespace rubsweep::page
