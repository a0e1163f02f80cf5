#include "rubsweep/report/map_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rubsweep::report {
namespace {

std::string name_of(const sweep::Row& row) {
  std::string name(response::to_string(row.motion_class));
  if (row.order && *row.order > 1) name += fmt::format(" 1/{}", *row.order);
  return name;
}

}  // namespace

std::string map_summary(const std::vector<std::optional<sweep::Row>>& rows) {
  std::map<std::string, int> by_name, by_status;
  int total = 0;
  for (const auto& row : rows) {
    if (!row) continue;
    ++total;
    ++by_name[name_of(*row)];
    if (row->status != "ok") ++by_status[row->status];
  }
  std::vector<std::pair<std::string, int>> sorted(by_name.begin(), by_name.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, count] : sorted) {
    text += fmt::format("{:>8}  {:5.1f} %  {}\n", count, 100.0 * count / total, name);
  }
  for (const auto& [status, count] : by_status) text += fmt::format("{:>8}  status {}\n", count, status);
  return text;
}

}  // namespace rubsweep::report
