#include "rubsweep/config/machine/shaft_segment.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::size_t most_layers = 16;
constexpr yaml::Words<model::ShearCoefficient, 3> shear_coefficients{
    {"cowper", "hutchinson", "none"},
    {model::ShearCoefficient::cowper, model::ShearCoefficient::hutchinson, model::ShearCoefficient::none}};
constexpr yaml::Words<bool, 2> on_off{{"off", "on"}, {false, true}};

/// Reader and printer share this list.
template <class Fields>
void visit_words(Fields& fields, auto& layer) {
  fields.field("shear_coefficient", layer.shear_coefficient, shear_coefficients);
  fields.field("rotary_inertia", layer.rotary_inertia, on_off);
  fields.field("gyroscopic", layer.gyroscopic, on_off);
}

void read_words(yaml::Section& section, model::ShaftLayer& layer) {
  visit_words(section, layer);
  if (!section.is_sound()) return;
  if (const auto problem = model::diameter_problem(layer))
    section.refuse_together(problem->key, {problem->key}, problem->wrong, problem->allowed);
}

}  // namespace

void read_segment(yaml::Section& section, model::ShaftSegment& segment) {
  read_words(section, segment);
  const auto list = section.find("layers");
  if (!list) return;
  const auto items = read_list(*list, most_layers);
  if (!items) return;
  for (const yaml::Value& item : *items) {
    yaml::Section layer(item);
    read_fields(layer, segment.layers.emplace_back());
    read_words(layer, segment.layers.back());
    layer.refuse_unknown_keys();
  }
}

void print_segment(yaml::Printer& printer, const model::ShaftSegment& segment) {
  visit_words(printer, segment);
  if (segment.layers.empty()) return;
  printer.open("layers");
  for (const model::ShaftLayer& layer : segment.layers) {
    printer.open_item();
    print_fields(printer, layer);
    visit_words(printer, layer);
    printer.close();
  }
  printer.close();
}

}  // namespace rubsweep::config::machine
