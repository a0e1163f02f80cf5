#include "rubsweep/maps/config/machine/rotor_kit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "rubsweep/core/model/disc_inertia.hpp"
#include "rubsweep/core/model/shaft_end.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::size_t most_parts = model::RotorKit::most_parts;

/// Reads the table of coefficients of a support into `part`; false where no table is given.
template <class Part>
bool read_table(yaml::Section& section, Part& part) {
  if constexpr (std::is_same_v<Part, model::Support>) {
    const auto value = section.find("table");
    if (!value) return false;
    Part::visit_fields(part, [&](std::string_view name, auto&, const model::Range&) {
      if (const auto beside = is_coefficient(name) ? section.find(name) : std::nullopt)
        refuse(*beside, "is given beside a table", "a column of the table");
    });
    if (auto table = read_support_table(*value)) part = model::with_table(part, *std::move(table));
    return true;
  }
  return false;
}

/// Reads the numbers of a part; its position must be within `range`. A support at a housing has no position.
template <class Part>
void read_part(yaml::Section& section, Part& part, const model::Range& range) {
  bool on_shaft = true;
  if constexpr (std::is_same_v<Part, model::Support>) on_shaft = !section.find("at_housing");
  if constexpr (std::is_same_v<Part, model::Disc>) read_disc_geometry(section, part);
  if constexpr (requires { part.name; })
    if (const auto name = section.find("name")) part.name = read_text(*name).value_or("");
  const bool by_table = read_table(section, part);
  Part::visit_fields(part, [&](std::string_view name, auto& field, const auto& allowed) {
    if (by_table && is_coefficient(name)) return;
    if (name == "position_m") {
      if (on_shaft) section.field(name, field, range);
    } else {
      section.field(name, field, allowed);
    }
  });
}

template <class Part, class More>
std::vector<Part> read_parts(const yaml::Value& list, const model::Range& range, More more) {
  std::vector<Part> parts;
  for (const yaml::Value& item : read_list(list, most_parts)) {
    yaml::Section section(item);
    Part& part = parts.emplace_back();
    read_part(section, part, range);
    more(section, part);
  }
  return parts;
}

constexpr auto nothing_more = [](yaml::Section&, auto&) {};

void read_inertia(yaml::Section& section, const model::Disc& disc) {
  const double most = model::largest_polar_inertia_kg_m2(disc);
  if (!section.is_sound() || disc.polar_inertia_kg_m2 <= most) return;
  section.refuse_together(
      "polar_inertia_kg_m2", {"polar_inertia_kg_m2", "diametral_inertia_kg_m2"},
      "is more than twice the diametral one, which no body has",
      fmt::format("at most {} = 2 diametral_inertia_kg_m2", 2 * disc.diametral_inertia_kg_m2));
}

void refuse_problem(yaml::Section& section, const std::optional<model::PartProblem>& problem) {
  if (problem && section.is_sound()) section.refuse(problem->key, problem->wrong, problem->allowed);
}

template <class Part>
void read_inner(yaml::Section& section, std::string_view name, std::optional<Part>& part) {
  if (const auto value = section.find(name)) read_map(*value, part.emplace());
}

void read_housing(yaml::Section& section, std::string_view name, std::optional<int>& housing,
                  std::size_t count) {
  const auto value = section.find(name);
  if (!value) return;
  if (count == 0) {
    refuse(*value, "there are no housings", "a support of the shaft on the ground, or housings beside it");
  } else if (const auto number = read_integer(*value, {0, static_cast<long>(count) - 1})) {
    housing = static_cast<int>(*number);
  }
}

void read_support(yaml::Section& section, model::Support& support, const model::RotorKit& kit) {
  read_inner(section, "pedestal", support.pedestal);
  if (const auto value = section.find("fault")) support.fault = read_bearing_fault(*value);
  read_housing(section, "at_housing", support.at_housing, kit.housings.size());
  read_housing(section, "on_housing", support.on_housing, kit.housings.size());
  if (section.find("at_housing") && section.find("position_m"))
    section.require_exactly_one({"position_m", "at_housing"});
  refuse_problem(section, model::housing_problem(support));
}

template <class Part>
void print_inner(yaml::Printer& printer, std::string_view name, const std::optional<Part>& part) {
  if (part) print_map(printer, name, *part);
}

/// Whether a number of a part is printed. Not printed are the position of a support at a housing,
/// coefficients that a table replaces, and added masses that are all 0.
template <class Part>
bool shows(const Part& part, std::string_view key) {
  if constexpr (std::is_same_v<Part, model::Support>) {
    if (key == "position_m") return !part.at_housing;
    if (part.table) return !is_coefficient(key);
    return !key.starts_with("mass_") || part.mass_x_kg != 0 || part.mass_y_kg != 0;
  }
  return true;
}

template <class Part, class More>
void print_parts(yaml::Printer& printer, std::string_view name, const std::vector<Part>& parts, More more) {
  if (parts.empty()) return;
  printer.open(name);
  for (const Part& part : parts) {
    printer.open_item();
    Part::visit_fields(part, [&](std::string_view key, const auto& field, const model::Range& range) {
      if (shows(part, key)) printer.field(key, field, range);
    });
    if constexpr (requires { part.name; })
      if (!part.name.empty()) printer.text("name", part.name);
    more(part);
    printer.close();
  }
  printer.close();
}

}  // namespace

model::Range places(const model::RotorKit& kit) {
  const double length_m = model::shaft_length_m(kit);
  const bool known = kit.matrices || !kit.shaft.empty();
  return known && std::isfinite(length_m) ? model::Range{.low = 0, .high = model::furthest_place_m(length_m)}
                                          : model::not_negative;
}

void refuse_loose_shaft(const yaml::Value& supports, const model::RotorKit& kit) {
  const auto unknown = [](const model::Support& support) { return std::isnan(support.stiffness_x_n_per_m); };
  if (std::ranges::any_of(kit.supports, unknown)) return;  // its table could not be read
  for (const int plane : {0, 1}) {
    if (model::supports_hold(kit, plane)) continue;
    refuse(supports,
           fmt::format("leaves the shaft{} free to move in {}", kit.housings.empty() ? "" : " or a housing",
                       plane == 0 ? "x" : "y"),
           kit.housings.empty() ? "supports that hold the shaft" : "supports that hold all of them");
  }
}

void read_supports(const yaml::Value& supports, model::RotorKit& kit) {
  kit.supports = read_parts<model::Support>(
      supports, places(kit),
      [&](yaml::Section& part, model::Support& support) { read_support(part, support, kit); });
}

void refuse_tables(const yaml::Value& supports, yaml::Section& section, const model::RotorKit& kit) {
  if (!model::has_tables(kit)) return;
  const model::Range common = model::table_speeds_hz(kit);
  if (!(common.low <= common.high))
    refuse(supports, "have tables without a common speed", "tables that overlap");
  if (const auto bow = section.find("bow"); bow && std::holds_alternative<model::BowMode>(kit.bow->shape))
    refuse(*bow, "is a mode, and the modes follow the tables of the supports", "position_m and deflection_m");
}

void refuse_torsion(yaml::Section& section, const model::RotorKit& kit) {
  const auto torsion = section.find("torsion");
  if (torsion && std::ranges::any_of(kit.couplings, model::is_asymmetric))
    refuse(
        *torsion,
        "is given beside a coupling with an asymmetry ratio, whose force does not know the angle of torsion",
        "couplings that are equally stiff all around");
}

void read_kit_rest(yaml::Section& section, model::RotorKit& kit) {
  const auto list = [&](std::string_view name, auto& parts) {
    using Part = typename std::remove_reference_t<decltype(parts)>::value_type;
    if (const auto value = section.find(name)) parts = read_parts<Part>(*value, places(kit), nothing_more);
  };
  list("static_loads", kit.static_loads);
  list("sensors", kit.sensors);
  if (const auto value = section.find("bow")) kit.bow = read_bow(*value, places(kit));
  read_inner(section, "torsion", kit.torsion);
  read_fields(section, kit);
  if (const auto value = section.find("rotating_damping_ratio");
      value && model::has_rotating_damping(kit) && model::has_pedestals(kit))
    refuse(*value, "turns with the shaft, and pedestals do not", "0 beside pedestals");
}

model::RotorKit read_rotor_kit(yaml::Section& section) {
  model::RotorKit kit;
  const auto list = [&](std::string_view name, auto& parts, auto more) {
    using Part = typename std::remove_reference_t<decltype(parts)>::value_type;
    constexpr bool coupling = std::is_same_v<Part, model::Coupling>;
    const model::Range range =
        coupling && std::isfinite(model::shaft_length_m(kit)) ? model::coupling_places(kit) : places(kit);
    if (const auto value = section.find(name)) parts = read_parts<Part>(*value, range, more);
  };
  section.require("shaft", "a list of maps");
  list("shaft", kit.shaft, read_segment);
  list("discs", kit.discs, read_inertia);
  const auto supports = section.require("supports", "a list of maps");
  list("point_masses", kit.point_masses, nothing_more);
  list("housings", kit.housings, nothing_more);
  if (supports) read_supports(*supports, kit);
  list("couplings", kit.couplings, nothing_more);
  read_kit_rest(section, kit);
  if (supports && section.is_sound()) refuse_loose_shaft(*supports, kit);
  if (supports && section.is_sound()) refuse_tables(*supports, section, kit);
  if (section.is_sound()) refuse_torsion(section, kit);
  return kit;
}

void print_rotor_kit(yaml::Printer& printer, const model::RotorKit& kit, MatrixPrint matrices) {
  const auto nothing = [](const auto&) {};
  if (kit.matrices) print_shaft_matrices(printer, *kit.matrices, matrices);
  print_parts(printer, "shaft", kit.shaft,
              [&](const model::ShaftSegment& segment) { print_segment(printer, segment); });
  print_parts(printer, "discs", kit.discs, nothing);
  print_parts(printer, "point_masses", kit.point_masses, nothing);
  print_parts(printer, "housings", kit.housings, nothing);
  print_parts(printer, "supports", kit.supports, [&](const model::Support& support) {
    if (support.at_housing) printer.integer("at_housing", *support.at_housing);
    if (support.on_housing) printer.integer("on_housing", *support.on_housing);
    if (support.table) print_support_table(printer, *support.table);
    print_inner(printer, "pedestal", support.pedestal);
    print_inner(printer, "fault", support.fault);
  });
  print_parts(printer, "couplings", kit.couplings, nothing);
  print_parts(printer, "static_loads", kit.static_loads, nothing);
  print_parts(printer, "sensors", kit.sensors, nothing);
  if (kit.bow) print_bow(printer, *kit.bow);
  print_inner(printer, "torsion", kit.torsion);
  model::RotorKit::visit_fields(kit, [&](std::string_view name, const auto& field, const auto& key) {
    const bool left_out = name == "mass_damping_per_s" ? kit.mass_damping_per_s == 0
                                                       : name == "elements" && kit.matrices != nullptr;
    if (!left_out) printer.field(name, field, key);
  });
}

}  // namespace rubsweep::config::machine
