#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/machine/table_file.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/table/unit.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view table_forms =
    "a map with file, or one with speed_hz, speed_rpm or speed_rad_per_s, kxx, kyy and others";
/// Ending of a column's name, and the size of its unit in SI units.
struct Ending {
  std::string_view ending;
  double in_si = 0;
};
constexpr std::array<Ending, 5> of_stiffness{
    {{"", 1}, {"_n_per_m", 1}, {"_n_per_mm", 1e3}, {"_n_per_um", 1e6}, {"_lbf_per_in", table::lbf_per_in}}};
constexpr std::array<Ending, 4> of_damping{
    {{"", 1}, {"_ns_per_m", 1}, {"_ns_per_mm", 1e3}, {"_lbf_s_per_in", table::lbf_per_in}}};
constexpr std::array<Ending, 2> of_mass{{{"", 1}, {"_kg", 1}}};

/// Names that a column of model::support_coefficients may have, each with its unit in SI. Built only once.
const std::vector<std::pair<std::string, double>>& names_of(std::size_t column) {
  static const auto all = [] {
    std::array<std::vector<std::pair<std::string, double>>, model::support_coefficients.size()> names;
    for (std::size_t c = 0; c < names.size(); ++c) {
      const std::string coefficient(model::support_coefficients[c]);
      const std::span<const Ending> units = coefficient[0] == 'k'   ? std::span<const Ending>(of_stiffness)
                                            : coefficient[0] == 'c' ? std::span<const Ending>(of_damping)
                                                                    : of_mass;
      for (const auto& [ending, in_si] : units)
        names[c].emplace_back(coefficient + std::string(ending), in_si);
    }
    return names;
  }();
  return all[column];
}

constexpr std::array<std::string_view, 3> speed_keys{"speed_hz", "speed_rpm", "speed_rad_per_s"};

bool is_needed(std::string_view column) { return column == "kxx" || column == "kyy"; }

std::vector<double> read_column(const yaml::Value& value, const model::Range& range, double in_si) {
  std::vector<double> numbers;
  for (const yaml::Value& item : read_list(value, model::SupportTable::most_points)) {
    const auto number = read_number(item, model::any_finite);
    if (!number) continue;
    if (!model::contains(range, *number * in_si))
      refuse(item, fmt::format("{} is out of range", yaml::shown(item.node.text)),
             model::describe(range, *number * in_si));
    numbers.push_back(*number * in_si);
  }
  return numbers;
}

/// Column of speeds, in any of its units.
std::optional<yaml::Value> find_speeds(yaml::Section& section) {
  section.require_exactly_one(speed_keys);
  std::optional<yaml::Value> found;
  for (const std::string_view name : speed_keys)
    if (const auto value = section.find(name); value && !found) found.emplace(*value);
  return found;
}

/// Speeds of the column in Hz, in their given order.
std::vector<double> read_speeds(const yaml::Value& given) {
  std::vector<double> speeds = read_column(given, model::not_negative, 1);
  for (double& speed : speeds) {
    if (given.path.ends_with("_rpm")) speed /= model::rpm_per_hz;  // rounded like the speeds of a sweep
    if (given.path.ends_with("_rad_per_s")) speed /= 2 * std::numbers::pi;
  }
  return speeds;
}

/// Removes rows that repeat the row before them. Speeds of the other rows must all rise or all fall.
void order_rows(model::SupportTable& table, const yaml::Value& speeds) {
  std::vector<double>& hz = table.speed_hz;
  const auto differ = std::ranges::adjacent_find(hz, std::not_equal_to<>{});
  const bool falling = differ != hz.end() && differ[1] < differ[0];
  for (std::size_t i = 1; i < hz.size(); ++i) {
    if (falling ? hz[i] < hz[i - 1] : hz[i] > hz[i - 1]) continue;
    const bool repeats = hz[i] == hz[i - 1] && std::ranges::all_of(table.columns, [&](const auto& column) {
                           return column[i] == column[i - 1];
                         });
    if (!repeats) {
      const auto items = speeds.node.items.size();
      const std::size_t place = i + items - hz.size();
      const yaml::Value item = speeds.at(place);
      refuse(item,
             fmt::format("{} is not {} the speed before it", yaml::shown(item.node.text),
                         falling ? "below" : "above"),
             falling ? "speeds that rise, or that fall" : "speeds that rise");
      return;
    }
    const auto row = static_cast<std::ptrdiff_t>(i--);
    hz.erase(hz.begin() + row);
    for (auto& column : table.columns) column.erase(column.begin() + row);
  }
  if (!falling) return;
  std::ranges::reverse(hz);
  for (auto& column : table.columns) std::ranges::reverse(column);
}

/// Values of a coefficient's column in SI units, whichever unit it is given in; empty where the column is
/// missing.
std::optional<std::vector<double>> find_column(yaml::Section& section, std::size_t column,
                                               std::size_t points) {
  std::optional<std::vector<double>> found;
  std::string_view first;
  for (const auto& [name, in_si] : names_of(column)) {
    const auto value = section.find(name);
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

/// Ending of a key for the unit of a column; empty where there is none for this unit.
std::string_view ending_of(std::string_view words) {
  const auto unit = table::unit_of(words);
  if (!unit) return {};
  const auto among = [&](std::span<const Ending> endings) -> std::string_view {
    const auto of_size = std::ranges::find(endings.subspan(1), unit->in_si, &Ending::in_si);
    return of_size == endings.end() ? std::string_view() : of_size->ending;
  };
  constexpr std::array<Ending, 4> of_turning{
      {{"", 1}, {"_hz", 1}, {"_rpm", 1.0 / 60}, {"_rad_per_s", 0.5 / std::numbers::pi}}};
  switch (unit->quantity) {
    case table::Quantity::stiffness: return among(of_stiffness);
    case table::Quantity::damping: return among(of_damping);
    case table::Quantity::mass: return among(of_mass);
    case table::Quantity::turning:
    case table::Quantity::rate: return among(of_turning);
    default: return {};
  }
}

/// Key of a column of a table of supports: "Kxx [N/mm]" is kxx_n_per_mm, "Speed (rpm)" speed_rpm.
ColumnKey key_of_support(const table::Heading& heading) {
  if (const std::size_t slash = heading.name.rfind('/'); slash != std::string::npos) {
    // Headings such as "Speed / rpm" or "K_xx / (N/m)".
    const std::size_t parted = heading.name.find('/');
    const std::string behind = heading.name.substr(parted + 1);
    if (heading.unit.empty() == (slash + 1 == heading.name.size())) return {};
    return key_of_support({heading.name.substr(0, parted), heading.unit.empty() ? behind : heading.unit});
  }
  std::string name = table::in_small_letters(heading.name);
  std::erase(name, ' ');
  if (name.size() == 4 && name[1] == '_') name.erase(1, 1);  // K_xx
  const bool turns = name == "n";
  constexpr std::array<std::string_view, 5> speeds{"omega", "n", "rotorspeed", "\u03c9", "\u03a9"};
  if (std::ranges::find(speeds, name) != speeds.end()) name = "speed";
  if (name == "rpm") name = "speed_rpm";
  std::string stem = name.substr(0, name.find('_'));
  const bool speed = stem == "speed";
  if (!speed && std::ranges::find(model::support_coefficients, stem) == model::support_coefficients.end())
    return {};
  const std::string_view ending = ending_of(heading.unit);
  const std::string in_words = heading.name + (heading.unit.empty() ? "" : " [" + heading.unit + ']');
  if (name == "speed" && heading.unit.empty())
    return {"speed", fmt::format("'{}' says no unit", yaml::shown(in_words)),
            "rpm, Hz or rad/s behind it or below it, or as speed_unit beside file"};
  if (heading.unit.empty()) return {name};
  const bool stiffness = ending.starts_with("_n_per") || ending == "_lbf_per_in";
  const bool damping = ending.starts_with("_ns_per") || ending == "_lbf_s_per_in";
  // 1/s may mean rad/s for a frequency, but revolutions per second for a number of turns `n`.
  const bool unclear = !turns && ending == "_hz" && heading.unit.find('1') != std::string::npos;
  const bool fits = unclear          ? false
                    : speed          ? ending == "_rpm" || ending == "_hz" || ending == "_rad_per_s"
                    : stem[0] == 'k' ? stiffness
                    : stem[0] == 'c' ? damping
                                     : ending == "_kg";
  if (!fits || (name != stem && name != stem + std::string(ending)))
    return {name,
            fmt::format("the unit of '{}' is unknown, or another one than it says", yaml::shown(in_words)),
            speed ? "rpm, Hz, rad/s" : "N/m, N/mm, N/um, lbf/in; N s/m, N s/mm, lbf s/in; kg"};
  return {stem + std::string(ending)};
}

/// Takes `speed_unit` out of a map that names a file: the unit of speeds where the file gives none.
void resolve_table(yaml::Node& table, const std::string& path, yaml::Diagnostics& diagnostics) {
  const yaml::Node* given = child(&table, "file") == nullptr ? nullptr : child(&table, "speed_unit");
  if (given == nullptr) return resolve_table_file(table, path, key_of_support, diagnostics);
  const yaml::Node written = *given;
  const yaml::Value value{written, path + ".speed_unit", diagnostics};
  const auto unit = read_text(value);
  const auto place = given - table.items.data();
  drop_entry(table, static_cast<std::size_t>(place));
  constexpr std::array<std::string_view, 3> units{"rpm", "Hz", "rad/s"};
  if (!unit) return;
  if (std::ranges::find(units, *unit) == units.end()) {
    refuse(value, fmt::format("'{}' is no unit of speeds", yaml::shown(*unit)), "rpm, Hz or rad/s");
    return;
  }
  bool is_needed = false;
  const auto key_of = [&](const table::Heading& heading) {
    ColumnKey key = key_of_support(heading);
    if (key.key != "speed" || !heading.unit.empty()) return key;
    is_needed = true;
    return key_of_support({heading.name, *unit});
  };
  const std::size_t problems = diagnostics.count();
  resolve_table_file(table, path, key_of, diagnostics);
  if (!is_needed && diagnostics.count() == problems)
    refuse(value, "is given, and the file says the unit of its speeds", "no speed_unit");
}

}  // namespace

void resolve_tables(yaml::Node& root, yaml::Diagnostics& diagnostics) {
  yaml::Node* supports = child(child(&root, "rotor"), "supports");
  if (supports == nullptr || supports->kind != yaml::Node::Kind::list) return;
  for (std::size_t i = 0; i < supports->items.size(); ++i) {
    if (yaml::Node* table = child(&supports->items[i], "table"))
      resolve_table(*table, fmt::format("rotor.supports.{}.table", i), diagnostics);
  }
}

std::optional<model::SupportTable> read_support_table(const yaml::Value& value) {
  yaml::Section section(value, table_forms);
  if (!section.is_map() || section.find("file")) {
    section.allow_unknown_keys();  // the file could not be read, which was reported
    return std::nullopt;
  }
  model::SupportTable table;
  const auto speeds = find_speeds(section);
  if (speeds) table.speed_hz = read_speeds(*speeds);
  const std::size_t rows = speeds ? speeds->node.items.size() : 0;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    auto column = find_column(section, c, rows);
    const std::string_view name = model::support_coefficients[c];
    if (!column && is_needed(name))
      section.require(
          name,
          fmt::format("numbers under {0}, {0}_n_per_m, {0}_n_per_mm, {0}_n_per_um or {0}_lbf_per_in", name));
    table.columns[c] = column ? *std::move(column) : std::vector<double>(table.speed_hz.size(), 0.0);
  }
  section.refuse_unknown_keys();
  if (!section.is_sound()) return std::nullopt;
  order_rows(table, *speeds);
  if (!section.is_sound()) return std::nullopt;
  return table;
}

keys::Form support_table_form() {
  using namespace keys;
  const auto numbers = [](const model::Range& range) {
    return list_of(number(range), 1, model::SupportTable::most_points);
  };
  const Form speeds = numbers(model::not_negative);
  std::vector<Key> columns{must("speed_hz", speeds, "speeds, all rising or all falling"),
                           must("speed_rpm", speeds, "the same in revolutions per minute"),
                           must("speed_rad_per_s", speeds, "the same in radians per second")};
  std::vector<Choice> choices{either(speed_keys)};
  for (std::size_t c = 0; c < model::support_coefficients.size(); ++c) {
    choices.push_back({{}, !is_needed(model::support_coefficients[c])});
    for (const auto& [name, in_si] : names_of(c)) {
      columns.push_back(
          must(name, numbers({}), "coefficient at these speeds, in the unit of its name or in SI"));
      choices.back().ways.push_back({{name}, {}});
    }
  }
  return any_of(
      {map_of({must("file", text(), "file of these columns, its name relative to this one"),
               newer_key(may("speed_unit", word({"rpm", "Hz", "rad/s"}),
                             "unit of the speeds of a file that says none", "(that of the file)"))}),
       map_of(std::move(columns), std::move(choices))});
}

void print_support_table(yaml::Printer& printer, const model::SupportTable& table) {
  printer.open("table");
  printer.numbers("speed_hz", table.speed_hz);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!is_needed(model::support_coefficients[c]) &&
        std::ranges::all_of(table.columns[c], [](double value) { return value == 0; }))
      continue;
    printer.numbers(names_of(c)[1].first, table.columns[c]);
  }
  printer.close();
}

}  // namespace rubsweep::config::machine
