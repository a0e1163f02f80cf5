#include "rubsweep/maps/report/explain_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/model/support_path.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::report {
namespace {

/// Its name in the file that it was read from.
std::string named(const model::Support& support) {
  return support.name.empty() ? "" : " (" + support.name + ")";
}

std::string place_of(const model::Support& support) {
  return support.at_housing ? fmt::format("housing {}", *support.at_housing)
                            : fmt::format("{:.6g} m", support.position_m);
}

std::string explain_coefficients(const model::SupportTable& table, double speed_hz) {
  const structure::SupportCurves curves = structure::curves_of(table);
  std::string text = fmt::format("    at {}:", model::speed_text(speed_hz));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const bool none = std::ranges::all_of(table.columns[c], [](double value) { return value == 0; });
    if (!none) text += fmt::format(" {} {:.6g}", model::support_coefficients[c], curves[c](speed_hz));
  }
  return text + "\n";
}

}  // namespace

std::string explain_tables(const model::Machine& machine, std::vector<double> speeds_hz) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || !model::has_tables(*kit)) return "";
  std::ranges::sort(speeds_hz);
  std::vector<double> shown{speeds_hz.front(), speeds_hz[speeds_hz.size() / 2], speeds_hz.back()};
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  std::string text = "supports that follow the speed (N/m, N s/m, kg), a cell has those of its own speed:\n";
  for (std::size_t i = 0; i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (!table) continue;
    text += fmt::format("  support {}{} at {}: table of {} speeds from {}, monotone cubics between\n", i,
                        named(kit->supports[i]), place_of(kit->supports[i]), table->speed_hz.size(),
                        model::speed_range_text(table->speed_hz.front(), table->speed_hz.back()));
    for (const double speed_hz : shown) text += explain_coefficients(*table, speed_hz);
  }
  return text;
}

std::string describe_sparse_tables(const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  std::string text;
  for (std::size_t i = 0; kit != nullptr && i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (table && table->speed_hz.size() < model::SupportTable::enough_points)
      text += fmt::format(
          "{}.table: has {} speeds, which leaves the curve between them to chance; {} or "
          "more are better\n",
          model::support_path(*kit, i), table->speed_hz.size(), model::SupportTable::enough_points);
  }
  return text;
}

}  // namespace rubsweep::report
