#include "rubsweep/config/machine/support_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/config/machine/table_file.hpp"
#include "rubsweep/config/yaml/section.hpp"
#include "rubsweep/config/yaml/text.hpp"
#include "rubsweep/model/magnitude.hpp"
#include "rubsweep/model/rpm.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view table_forms =
    "a map with file, or one with speed_hz or speed_rpm, kxx, kyy and others";

/// Name of a column and how many SI units its numbers count in.
struct Name {
  std::string_view text;
  double in_si = 0;
};

/// In the order of model::support_coefficients; the second name of each is printed.
constexpr std::array<std::array<Name, 4>, model::support_coefficients.size()> names{{
    {{{"kxx", 1}, {"kxx_n_per_m", 1}, {"kxx_n_per_mm", 1e3}, {"kxx_n_per_um", 1e6}}},
    {{{"kxy", 1}, {"kxy_n_per_m", 1}, {"kxy_n_per_mm", 1e3}, {"kxy_n_per_um", 1e6}}},
    {{{"kyx", 1}, {"kyx_n_per_m", 1}, {"kyx_n_per_mm", 1e3}, {"kyx_n_per_um", 1e6}}},
    {{{"kyy", 1}, {"kyy_n_per_m", 1}, {"kyy_n_per_mm", 1e3}, {"kyy_n_per_um", 1e6}}},
    {{{"cxx", 1}, {"cxx_ns_per_m", 1}, {"cxx_ns_per_mm", 1e3}}},
    {{{"cxy", 1}, {"cxy_ns_per_m", 1}, {"cxy_ns_per_mm", 1e3}}},
    {{{"cyx", 1}, {"cyx_ns_per_m", 1}, {"cyx_ns_per_mm", 1e3}}},
    {{{"cyy", 1}, {"cyy_ns_per_m", 1}, {"cyy_ns_per_mm", 1e3}}},
    {{{"mxx", 1}, {"mxx_kg", 1}}},
    {{{"myy", 1}, {"myy_kg", 1}}},
}};

std::vector<double> read_column(const yaml::Value& value, const model::Range& range, double in_si) {
  std::vector<double> numbers;
  const auto items = read_list(value, model::SupportTable::most_points);
  if (!items) return numbers;
  for (const yaml::Value& item : *items) {
    const auto number = read_number(item, model::any_finite);
    if (!number) continue;
    if (!model::contains(range, *number * in_si))
      refuse(item, fmt::format("{} is out of range", yaml::shown(item.node.text)),
             model::describe(range, *number * in_si));
    numbers.push_back(*number * in_si);
  }
  return numbers;
}

std::vector<double> read_speeds(yaml::Section& section) {
  constexpr std::string_view hz = "speed_hz", rpm = "speed_rpm";
  section.require_exactly_one({hz, rpm});
  const auto in_hz = section.find(hz), in_rpm = section.find(rpm);
  if (!in_hz && !in_rpm) return {};
  const yaml::Value value = in_hz ? *in_hz : *in_rpm;
  std::vector<double> speeds = read_column(value, model::not_negative, 1);
  if (!in_hz)
    for (double& speed : speeds)
      speed /= model::rpm_per_hz;  // as the speeds of a sweep: knots meet to the last bit
  for (std::size_t i = 1; i < speeds.size() && speeds.size() == value.node.items.size(); ++i) {
    if (speeds[i] > speeds[i - 1]) continue;
    const yaml::Value item{value.node.items[i], fmt::format("{}.{}", value.path, i), value.diagnostics};
    refuse(item, fmt::format("{} is not above the speed before it", yaml::shown(item.node.text)),
           "speeds that rise");
    break;
  }
  return speeds;
}

/// Column of a coefficient in whatever unit it is given; empty where it is not.
std::optional<std::vector<double>> find_column(yaml::Section& section, std::size_t column,
                                               std::size_t points) {
  std::optional<std::vector<double>> found;
  std::string_view first;
  for (const auto& [name, in_si] : names[column]) {
    const auto value = name.empty() ? std::nullopt : section.find(name);
    if (!value) continue;
    if (found) {
      refuse(*value, fmt::format("given beside {}", first), "one of them");
      continue;
    }
    first = name;
    found = read_column(*value, model::range_of_column(column), in_si);
    if (points > 0 && value->node.kind == yaml::Node::Kind::list && value->node.items.size() != points)
      refuse(*value, fmt::format("holds {} numbers", value->node.items.size()),
             fmt::format("{}, as many as there are speeds", points));
  }
  return found;
}

}  // namespace

void resolve_tables(yaml::Node& root, yaml::Diagnostics& diagnostics) {
  yaml::Node* supports = child(child(&root, "rotor"), "supports");
  if (supports == nullptr || supports->kind != yaml::Node::Kind::list) return;
  for (std::size_t i = 0; i < supports->items.size(); ++i) {
    if (yaml::Node* table = child(&supports->items[i], "table"))
      resolve_table_file(*table, fmt::format("rotor.supports.{}.table", i), diagnostics);
  }
}

std::optional<model::SupportTable> read_support_table(const yaml::Value& value) {
  yaml::Section section(value, table_forms);
  if (!section.is_map() || section.find("file"))
    return std::nullopt;  // a file that could not be had was refused
  model::SupportTable table;
  table.speed_hz = read_speeds(section);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    auto column = find_column(section, c, table.speed_hz.size());
    const std::string_view name = model::support_coefficients[c];
    if (!column && (name == "kxx" || name == "kyy"))
      section.require(name,
                      fmt::format("numbers under {0}, {0}_n_per_m, {0}_n_per_mm or {0}_n_per_um", name));
    table.columns[c] = column ? *std::move(column) : std::vector<double>(table.speed_hz.size(), 0.0);
  }
  section.refuse_unknown_keys();
  if (!section.is_sound()) return std::nullopt;
  return table;
}

void print_support_table(yaml::Printer& printer, const model::SupportTable& table) {
  printer.open("table");
  printer.numbers("speed_hz", table.speed_hz);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string_view name = model::support_coefficients[c];
    const bool needed = name == "kxx" || name == "kyy";
    if (!needed && std::ranges::all_of(table.columns[c], [](double value) { return value == 0; })) continue;
    printer.numbers(names[c][1].text, table.columns[c]);
  }
  printer.close();
}

}  // namespace rubsweep::config::machine
