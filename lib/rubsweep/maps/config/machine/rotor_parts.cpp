#include <optional>
#include <variant>

#include "rubsweep/core/model/disc_geometry.hpp"
#include "rubsweep/core/model/rolling_bearing.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"

namespace rubsweep::config::machine {
namespace {

void read_words(yaml::Section& section, model::ShaftLayer& layer) {
  model::ShaftLayer::visit_words(layer, model::fields_into(section));
  if (!section.is_sound()) return;
  if (const auto problem = model::diameter_problem(layer))
    section.refuse(problem->key, problem->wrong, problem->allowed);
}

model::BowPoints read_bow_points(yaml::Section& section, const model::Range& range) {
  model::BowPoints points;
  if (const auto positions = section.require("position_m", "a list of numbers")) {
    points.position_m = read_number_list(*positions, range, model::RotorKit::most_parts);
  }
  if (const auto deflections = section.require("deflection_m", "a list of numbers")) {
    points.deflection_m =
        read_number_list(*deflections, model::physical::deflection_m, model::RotorKit::most_parts);
  }
  return points;
}

std::optional<double> read_strikes(const yaml::Value& value) {
  yaml::Section section(value);
  model::RollingBearing bearing;
  const auto defect = section.require_kind("defect", bearing_defects);
  read_fields(section, bearing);
  section.refuse_unknown_keys();
  if (section.is_sound() && bearing.ball_diameter_m >= bearing.pitch_diameter_m) {
    section.refuse_together("ball_diameter_m", {"ball_diameter_m", "pitch_diameter_m"},
                            "leaves no room for a shaft", "a number below pitch_diameter_m");
  }
  if (!section.is_sound() || !defect) return std::nullopt;
  return model::strikes_per_revolution(bearing, static_cast<model::BearingDefect>(*defect));
}

}  // namespace

void read_segment(yaml::Section& section, model::ShaftSegment& segment) {
  read_words(section, segment);
  const auto list = section.find("layers");
  if (!list) return;
  for (const yaml::Value& item : read_list(*list, most_layers)) {
    yaml::Section layer(item);
    read_fields(layer, segment.layers.emplace_back());
    read_words(layer, segment.layers.back());
  }
}

void print_segment(yaml::Printer& printer, const model::ShaftSegment& segment) {
  model::ShaftLayer::visit_words(segment, model::fields_into(printer));
  if (segment.layers.empty()) return;
  printer.open("layers");
  for (const model::ShaftLayer& layer : segment.layers) {
    printer.open_item();
    print_fields(printer, layer);
    model::ShaftLayer::visit_words(layer, model::fields_into(printer));
    printer.close();
  }
  printer.close();
}

model::Bow read_bow(const yaml::Value& value, const model::Range& range) {
  yaml::Section section(value);
  model::Bow bow;
  section.require_exactly_one({"mode", "position_m"});
  if (section.find("mode")) {
    auto& mode = bow.shape.emplace<model::BowMode>();
    section.field("mode", mode.mode, yaml::IntegerRange{1, model::RotorKit::most_modes});
    section.field("amplitude_m", mode.amplitude_m, model::physical::amplitude_m);
  } else if (section.is_sound()) {
    bow.shape = read_bow_points(section, range);
  }
  section.field("phase_deg", bow.phase_deg, model::any_finite);
  return bow;
}

void print_bow(yaml::Printer& printer, const model::Bow& bow) {
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

void read_disc_geometry(yaml::Section& section, model::Disc& disc) {
  const auto value = section.find("geometry");
  if (!value) return;
  for (const std::string_view number : disc_inertias) {
    if (section.find(number)) section.require_exactly_one({number, "geometry"});
  }
  yaml::Section inner(*value);
  model::DiscGeometry geometry;
  read_fields(inner, geometry);
  inner.refuse_unknown_keys();
  if (inner.is_sound() && geometry.inner_diameter_m >= geometry.outer_diameter_m) {
    inner.refuse("inner_diameter_m", "no disc is left", "a number below outer_diameter_m");
  }
  // After a problem the disc is not used. Zeros are then returned, because they cause no further problem.
  const bool sound = inner.is_sound();
  disc.mass_kg = sound ? geometry.mass_kg() : 0;
  disc.polar_inertia_kg_m2 = sound ? geometry.polar_inertia_kg_m2() : 0;
  disc.diametral_inertia_kg_m2 = sound ? geometry.diametral_inertia_kg_m2() : 0;
}

model::BearingFault read_bearing_fault(const yaml::Value& value) {
  yaml::Section section(value);
  model::BearingFault fault;
  if (const auto bearing = section.find("bearing")) {
    if (section.find("multiple")) section.require_exactly_one({"multiple", "bearing"});
    fault.multiple = read_strikes(*bearing).value_or(1);
  }
  read_fields(section, fault);
  return fault;
}

}  // namespace rubsweep::config::machine
