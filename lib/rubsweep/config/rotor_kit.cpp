#include "rubsweep/config/rotor_kit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <type_traits>

#include "rubsweep/model/disc_inertia.hpp"
#include "rubsweep/overloaded.hpp"

namespace rubsweep::config {
namespace {

constexpr std::size_t most_parts = 64;
constexpr std::string_view automatic = "auto";
constexpr IntegerRange mode_counts{1, model::RotorKit::most_modes};
constexpr IntegerRange element_counts{1, model::RotorKit::most_elements};

/// Reads a part, its position within `range`.
template <class Part>
void read_part(Section& section, Part& part, const model::Range& range) {
  Part::visit_fields(part, [&](std::string_view name, double& field, const model::Range& allowed) {
    section.field(name, field, name == "position_m" ? range : allowed);
  });
}

template <class Part, class More>
std::vector<Part> read_parts(const Value& list, const model::Range& range, More more) {
  std::vector<Part> parts;
  const auto items = read_list(list, most_parts);
  if (!items) return parts;
  for (const Value& item : *items) {
    Section section(item);
    Part& part = parts.emplace_back();
    read_part(section, part, range);
    more(section, part);
    section.refuse_unknown_keys();
  }
  return parts;
}

constexpr auto nothing_more = [](Section&, auto&) {};

void read_inertia(Section& section, const model::Disc& disc) {
  const double most = model::largest_polar_inertia_kg_m2(disc);
  if (!section.is_sound() || disc.polar_inertia_kg_m2 <= most) return;
  section.refuse_together(
      "polar_inertia_kg_m2", {"polar_inertia_kg_m2", "diametral_inertia_kg_m2"},
      "is more than twice the diametral one, which no body has",
      fmt::format("at most {} = 2 diametral_inertia_kg_m2", 2 * disc.diametral_inertia_kg_m2));
}

void read_hole(Section& section, const model::ShaftSegment& segment) {
  if (!(segment.inner_diameter_m >= segment.outer_diameter_m)) return;
  section.refuse_together("inner_diameter_m", {"inner_diameter_m"}, "no wall is left",
                          "a number below outer_diameter_m");
}

template <class Part>
void read_inner(Section& section, std::string_view name, std::optional<Part>& part) {
  const auto value = section.find(name);
  if (!value) return;
  Section inner(*value);
  read_fields(inner, part.emplace());
  inner.refuse_unknown_keys();
}

void read_inner_parts(Section& section, model::Support& support) {
  read_inner(section, "pedestal", support.pedestal);
  read_inner(section, "fault", support.fault);
}

std::vector<double> read_number_list(const Value& value, const model::Range& range) {
  std::vector<double> numbers;
  const auto items = read_list(value, most_parts);
  if (!items) return numbers;
  for (const Value& item : *items) {
    if (const auto number = read_number(item, range)) numbers.push_back(*number);
  }
  return numbers;
}

model::BowPoints read_bow_points(Section& section, const model::Range& range) {
  model::BowPoints points;
  if (const auto positions = section.require("position_m", "a list of numbers")) {
    points.position_m = read_number_list(*positions, range);
  }
  if (const auto deflections = section.require("deflection_m", "a list of numbers")) {
    points.deflection_m = read_number_list(*deflections, model::physical::deflection_m);
  }
  return points;
}

model::Bow read_bow(const Value& value, const model::Range& range) {
  Section section(value);
  model::Bow bow;
  section.require_exactly_one({"mode", "position_m"});
  if (section.find("mode")) {
    auto& mode = bow.shape.emplace<model::BowMode>();
    section.field("mode", mode.mode, mode_counts);
    section.field("amplitude_m", mode.amplitude_m, model::physical::amplitude_m);
  } else if (section.is_sound()) {
    bow.shape = read_bow_points(section, range);
  }
  section.field("phase_deg", bow.phase_deg, model::any_finite);
  section.refuse_unknown_keys();
  return bow;
}

void read_damping_ratio(const Value& value, std::vector<double>& ratios) {
  if (value.node.kind == Node::Kind::list) {
    ratios = read_number_list(value, model::RotorKit::damping_ratio_range);
  } else if (const auto ratio = read_number(value, model::RotorKit::damping_ratio_range)) {
    ratios = {*ratio};
  }
}

void read_rotating_damping_ratio(const Value& value, model::RotorKit& kit) {
  read_damping_ratio(value, kit.rotating_damping_ratio);
  if (model::has_rotating_damping(kit) && model::has_pedestals(kit))
    refuse(value, "turns with the shaft, and pedestals do not", "0 beside pedestals");
}

void read_modes(const Value& value, model::RotorKit& kit) {
  if (value.node.kind == Node::Kind::scalar && value.node.text == automatic) {
    kit.modes.reset();
  } else if (const auto count = read_integer(value, mode_counts)) {
    kit.modes = static_cast<int>(*count);
  }
}

void refuse_loose_shaft(const Value& supports, const model::RotorKit& kit) {
  for (const int plane : {0, 1}) {
    if (model::supports_hold(kit, plane)) continue;
    refuse(supports, plane == 0 ? "leaves the shaft free to move in x" : "leaves the shaft free to move in y",
           "supports that hold the shaft");
  }
}

template <class Part>
void print_inner(Printer& printer, std::string_view name, const std::optional<Part>& part) {
  if (!part) return;
  printer.open(name);
  print_fields(printer, *part);
  printer.close();
}

template <class Part, class More>
void print_parts(Printer& printer, std::string_view name, const std::vector<Part>& parts, More more) {
  if (parts.empty()) return;
  printer.open(name);
  for (const Part& part : parts) {
    printer.open_item();
    print_fields(printer, part);
    more(part);
    printer.close();
  }
  printer.close();
}

void print_bow(Printer& printer, const model::Bow& bow) {
  printer.open("bow");
  std::visit(overloaded{[&](const model::BowMode& mode) {
                          printer.integer("mode", mode.mode);
                          printer.number("amplitude_m", mode.amplitude_m);
                        },
                        [&](const model::BowPoints& points) {
                          printer.numbers("position_m", points.position_m);
                          printer.numbers("deflection_m", points.deflection_m);
                        }},
             bow.shape);
  printer.number("phase_deg", bow.phase_deg);
  printer.close();
}

}  // namespace

model::Range places(const model::RotorKit& kit) {
  const double length_m = model::shaft_length_m(kit);
  return std::isfinite(length_m) ? model::Range{.low = 0, .high = length_m} : model::not_negative;
}

model::RotorKit read_rotor_kit(Section& section) {
  model::RotorKit kit;
  const auto list = [&](std::string_view name, auto& parts, auto more) {
    using Part = typename std::remove_reference_t<decltype(parts)>::value_type;
    constexpr bool coupling = std::is_same_v<Part, model::Coupling>;
    const model::Range range =
        coupling && std::isfinite(model::shaft_length_m(kit)) ? model::coupling_places(kit) : places(kit);
    if (const auto value = section.find(name)) parts = read_parts<Part>(*value, range, more);
  };
  section.require("shaft", "a list of maps");
  list("shaft", kit.shaft, read_hole);
  list("discs", kit.discs, read_inertia);
  const auto supports = section.require("supports", "a list of maps");
  list("supports", kit.supports, read_inner_parts);
  list("couplings", kit.couplings, nothing_more);
  list("sensors", kit.sensors, nothing_more);
  if (const auto value = section.find("bow")) kit.bow = read_bow(*value, places(kit));
  read_inner(section, "torsion", kit.torsion);
  if (const auto value = section.find("damping_ratio")) read_damping_ratio(*value, kit.damping_ratio);
  if (const auto value = section.find("rotating_damping_ratio")) read_rotating_damping_ratio(*value, kit);
  if (const auto value = section.find("modes")) read_modes(*value, kit);
  section.field("modes_up_to_hz", kit.modes_up_to_hz, model::physical::frequency_hz);
  section.field("elements", kit.elements, element_counts);
  if (supports && section.is_sound()) refuse_loose_shaft(*supports, kit);
  return kit;
}

void print_rotor_kit(Printer& printer, const model::RotorKit& kit) {
  const auto nothing = [](const auto&) {};
  print_parts(printer, "shaft", kit.shaft, nothing);
  print_parts(printer, "discs", kit.discs, nothing);
  print_parts(printer, "supports", kit.supports, [&](const model::Support& support) {
    print_inner(printer, "pedestal", support.pedestal);
    print_inner(printer, "fault", support.fault);
  });
  print_parts(printer, "couplings", kit.couplings, nothing);
  print_parts(printer, "sensors", kit.sensors, nothing);
  if (kit.bow) print_bow(printer, *kit.bow);
  print_inner(printer, "torsion", kit.torsion);
  printer.numbers("damping_ratio", kit.damping_ratio);
  printer.numbers("rotating_damping_ratio", kit.rotating_damping_ratio);
  if (kit.modes) {
    printer.integer("modes", *kit.modes);
  } else {
    printer.word("modes", automatic);
  }
  printer.number("modes_up_to_hz", kit.modes_up_to_hz);
  printer.integer("elements", kit.elements);
}

}  // namespace rubsweep::config
