#include "rubsweep/report/map_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/response/motion.hpp"

namespace rubsweep::report {
namespace {

/// Place of a column; no name or cell of the columns asked for is ever quoted.
std::size_t column(std::string_view name) {
  const std::string header = fmt::format(",{},", map_header());
  const std::size_t begin = header.find(fmt::format(",{},", name));
  return static_cast<std::size_t>(std::count(header.begin(), header.begin() + static_cast<long>(begin), ','));
}

std::string_view cell(std::string_view line, std::size_t column) {
  for (; column > 0; --column) line.remove_prefix(line.find(',') + 1);
  return line.substr(0, line.find(','));
}

}  // namespace

void MapSummary::add(std::string_view map_line) {
  static const std::size_t class_column = column("class"), order_column = column("order"),
                           status_column = column("status");
  std::string name(cell(map_line, class_column));
  const std::string_view order = cell(map_line, order_column), status = cell(map_line, status_column);
  if (!order.empty() && order != "1") name += fmt::format(" 1/{}", order);
  ++total_;
  ++by_name_[name];
  if (status != "ok") ++by_status_[std::string(status)];
}

bool MapSummary::has_failed_cells() const {
  return by_name_.contains(std::string(to_string(response::MotionClass::failed)));
}

std::string MapSummary::text() const {
  std::vector<std::pair<std::string, std::size_t>> sorted(by_name_.begin(), by_name_.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, count] : sorted) {
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total_);
    text += fmt::format("{:>8}  {:5.1f} %  {}\n", count, percent, name);
  }
  for (const auto& [status, count] : by_status_) text += fmt::format("{:>8}  status {}\n", count, status);
  return text;
}

}  // namespace rubsweep::report
