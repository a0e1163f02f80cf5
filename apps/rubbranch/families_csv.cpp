#include "families_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

using namespace branch::families;

namespace {

using batch::csv_number;

double speed_of(const sweep::Grid& grid, std::size_t cell) {
  return grid.speed_hz[cell % grid.speed_hz.size()];
}
double unbalance_of(const sweep::Grid& grid, std::size_t cell) {
  return grid.unbalance[cell / grid.speed_hz.size()];
}

/// Width of a cell between the midpoints to its neighbours on an axis; 0 where the axis has one value.
double width_of(const std::vector<double>& axis, std::size_t i) {
  if (axis.size() < 2) return 0;
  const double below = i > 0 ? (axis[i] - axis[i - 1]) / 2 : (axis[1] - axis[0]) / 2;
  const double above = i + 1 < axis.size() ? (axis[i + 1] - axis[i]) / 2 : (axis[i] - axis[i - 1]) / 2;
  return std::abs(below + above);
}

double area_of(const sweep::Grid& grid, const Family& family) {
  double area = 0;
  for (const auto& [cell, orbit] : family.orbits) {
    area += width_of(grid.speed_hz, cell % grid.speed_hz.size()) *
            width_of(grid.unbalance, cell / grid.speed_hz.size());
  }
  return area;
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::string boundaries_csv(const sweep::Grid& grid, const std::vector<Family>& families) {
  std::string text = fmt::format("family,kind,speed_hz,{}\n", to_string(grid.measure));
  for (std::size_t i = 0; i < families.size(); ++i) {
    for (const OutlineLine& line : outline_of(grid, families[i])) {
      for (const auto& [speed_hz, unbalance] : line.points)
        text += fmt::format("{},{},{},{}\n", i, line.kind, csv_number(speed_hz), csv_number(unbalance));
      text += fmt::format("{},{},,\n", i, line.kind);
    }
  }
  return text;
}

std::string families_csv(const sweep::Grid& grid, const std::vector<Family>& families) {
  std::string text = fmt::format(
      "family,order,hits,speed_hz,{0},cells_existing,cells_reached,share_reached,area_hz_times_{0},closing\n",
      to_string(grid.measure));
  for (std::size_t i = 0; i < families.size(); ++i) {
    const Family& family = families[i];
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", i, family.order(), family.hits(),
                        csv_number(speed_of(grid, family.seed)), csv_number(unbalance_of(grid, family.seed)),
                        family.orbits.size(), family.reached.size(),
                        csv_number(share(family.reached.size(), family.orbits.size())),
                        csv_number(area_of(grid, family)), to_string(family.closing()));
  }
  return text;
}

std::string edges_csv(const sweep::Grid& grid, std::span<const std::string> labels,
                      const std::vector<MapEdge>& edges) {
  std::string text = fmt::format("speed_hz_1,{0}_1,speed_hz_2,{0}_2,label_1,label_2,attribution,kind\n",
                                 to_string(grid.measure));
  for (const MapEdge& edge : edges) {
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_number(speed_of(grid, edge.first)),
                        csv_number(unbalance_of(grid, edge.first)), csv_number(speed_of(grid, edge.second)),
                        csv_number(unbalance_of(grid, edge.second)), labels[edge.first], labels[edge.second],
                        to_string(edge.attribution), edge.kind);
  }
  return text;
}

std::string contradictions_csv(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<LabelCheck>& checks) {
  std::string text = fmt::format("speed_hz,{},label,family,side,finding,contradiction,end,other_family\n",
                                 to_string(grid.measure));
  const auto number = [](const std::optional<std::size_t>& family) {
    return family ? fmt::format("{}", *family) : std::string();
  };
  for (const LabelCheck& check : checks) {
    if (check.finding == CheckResult::reached) continue;
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_number(speed_of(grid, check.cell)),
                        csv_number(unbalance_of(grid, check.cell)), labels[check.cell], number(check.family),
                        check.inside ? "inside" : "outside", to_string(check.finding),
                        contradicts(check.finding) ? 1 : 0, check.end, number(check.other_family));
  }
  return text;
}

std::string contradictions_summary(const std::vector<LabelCheck>& checks) {
  const auto count = [&](const auto& condition) { return std::ranges::count_if(checks, condition); };
  std::string text = fmt::format(
      "{} labels contradict the domains of the families: looked at {} inside, {} of the same kind just "
      "outside\n",
      count([](const LabelCheck& check) { return contradicts(check.finding); }),
      count([](const LabelCheck& check) { return check.inside; }),
      count([](const LabelCheck& check) { return !check.inside; }));
  for (const CheckResult finding : all_findings) {
    const auto found = count([&](const LabelCheck& check) { return check.finding == finding; });
    if (found > 0) text += fmt::format("{:8}  {}\n", found, to_string(finding));
  }
  return text;
}

std::string families_summary(const sweep::Grid& grid, const Families& families, std::size_t proven,
                             const std::vector<MapEdge>& edges) {
  std::string text =
      fmt::format("{} families of {} proven cells; the orbits of {} were not found again as stable ones\n",
                  families.list.size(), proven, families.not_followed.size());
  for (const std::size_t cell : families.not_followed)
    text += fmt::format("  not followed: {}, {} {:g}\n", model::speed_text(speed_of(grid, cell)),
                        to_string(grid.measure), unbalance_of(grid, cell));
  std::map<std::pair<Attribution, std::string_view>, std::size_t> counts;
  for (const MapEdge& edge : edges) ++counts[{edge.attribution, edge.kind}];
  text += fmt::format("{} edges between cells of different labels\n", edges.size());
  for (const auto& [what, count] : counts) {
    text += fmt::format("{:8} {:6.1f} %  {}{}{}\n", count, 100 * share(count, edges.size()),
                        to_string(what.first), what.second.empty() ? "" : " ", what.second);
  }
  return text;
}

}  // namespace rubsweep::apps
