#include "rubsweep/config/machine/bow.hpp"

#include <variant>

#include "rubsweep/config/yaml/section.hpp"
#include "rubsweep/overloaded.hpp"

namespace rubsweep::config::machine {
namespace {

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

}  // namespace

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
  section.refuse_unknown_keys();
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

}  // namespace rubsweep::config::machine
