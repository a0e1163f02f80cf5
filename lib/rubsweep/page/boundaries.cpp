#include "rubsweep/page/boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::page {
namespace {

/// The first column that is called `name`, or that begins with it.
std::optional<std::size_t> column_called(const batch::CsvTable& table, std::string_view name,
                                         bool or_begins = false) {
  const auto found = std::find_if(table.header.begin(), table.header.end(), [&](const std::string& header) {
    return header == name || (or_begins && header.starts_with(name));
  });
  if (found == table.header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.header.begin());
}

std::size_t unbalance_column(const batch::CsvTable& table, const std::string& measure) {
  if (const auto exact = column_called(table, measure)) return *exact;
  const auto other = column_called(table, "unbalance", true);
  if (other) return *other;
  throw IoError(fmt::format("{}: no column {} or unbalance", table.path.string(), measure));
}

}  // namespace

std::vector<Boundary> read_boundaries(const std::filesystem::path& path, const std::string& measure) {
  if (!std::filesystem::exists(path)) return {};
  const batch::CsvTable table = batch::read_csv(path);
  const std::size_t speed = batch::column(table, "speed_hz"), unbalance = unbalance_column(table, measure);
  const auto family = column_called(table, "family"), kind = column_called(table, "kind");
  std::vector<Boundary> boundaries;
  bool ended = true;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double x = batch::number(table, row, speed), y = batch::number(table, row, unbalance);
    const Boundary here{family ? table.rows[row][*family] : "", kind ? table.rows[row][*kind] : "", {}};
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
