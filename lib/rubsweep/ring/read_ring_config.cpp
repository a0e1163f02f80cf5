#include "rubsweep/ring/read_ring_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/study/sweep.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::config::ring {
namespace {

using rubsweep::ring::Parameter;

constexpr std::array ranges{model::not_negative, model::any_finite, inclinations, model::not_negative,
                            model::positive};
static_assert(ranges.size() == parameters.values.size(), "a range for each parameter");

/// Whether a parameter affects a load of this kind of motion.
bool knows(const rubsweep::ring::Load& load, Parameter parameter) {
  if (parameter == Parameter::inclination_deg) return load.motion == rubsweep::ring::Motion::both;
  if (parameter == Parameter::radial_stiffness_n_per_m)
    return load.motion != rubsweep::ring::Motion::tangential;
  if (parameter == Parameter::tangential_stiffness_n_per_m)
    return load.motion != rubsweep::ring::Motion::radial;
  return true;
}

constexpr std::string_view root_form = "a map with ring, loads, friction_coefficient, speed_rpm, output";

/// Checks the system as a whole.
void check_system(const rubsweep::ring::System& system, const yaml::Section& section) {
  try {
    rubsweep::ring::normal_form(system);
  } catch (const ConfigError& error) {
    section.refuse_together("loads", {"loads", "friction_coefficient"}, error.what(),
                            "masses and a friction coefficient with regular inertia");
  }
}

RingConfig read_sections(const yaml::Value& root) {
  yaml::Section section(root, root_form);
  section.find(yaml::base_key);  // resolved before; known here so that a misspelt key can be compared with it
  RingConfig config;
  rubsweep::ring::Study& study = config.study;
  study.system.friction_coefficient = model::required;
  if (const auto value = section.require("ring", "a map")) study.system.ring = read_ring(*value);
  if (const auto value = section.require("loads", "a list of maps")) {
    study.system.loads = read_ring_loads(*value, study.system.ring.radius_m);
  }
  section.field("friction_coefficient", study.system.friction_coefficient, model::not_negative);
  section.field("preload_n", study.system.preload_n, model::not_negative);
  if (const auto value = section.require("speed_rpm", study::axis_forms)) {
    study::AxisValues axis = study::read_axis(*value, speeds_rpm);
    study.speeds_rpm = std::move(axis.values);
    study.spacing = axis.spacing;
    std::sort(study.speeds_rpm.begin(), study.speeds_rpm.end());
  }
  if (const auto value = section.find("chart")) study.chart = read_ring_chart(*value, study.system.loads);
  if (const auto value = section.require("output", "a map")) config.output_directory = read_output(*value);
  read_captions(section, config.captions);
  section.refuse_unknown_keys();
  const std::size_t lines = study.chart ? study.chart->values.size() : 0;
  if (lines * study.speeds_rpm.size() > study::max_cells) {
    section.refuse_together(
        "chart", {"chart", "speed_rpm"},
        fmt::format("{} x {} = {} points", study.speeds_rpm.size(), lines, lines * study.speeds_rpm.size()),
        fmt::format("at most {}", study::max_cells));
  }
  if (section.is_sound()) check_system(study.system, section);
  return config;
}

void print(yaml::Printer& printer, const rubsweep::ring::Study& study, study::AxisPrint how) {
  print_ring(printer, study.system.ring);
  print_ring_loads(printer, study.system.loads);
  printer.number("friction_coefficient", study.system.friction_coefficient);
  printer.number("preload_n", study.system.preload_n);
  printer.open("speed_rpm");
  study::print_axis_values(printer, study.speeds_rpm,
                           how == study::AxisPrint::as_written ? study.spacing : std::nullopt);
  printer.close();
  if (study.chart) print_ring_chart(printer, *study.chart, how);
}

using namespace keys;

Form positive() { return number(model::positive); }
Form not_negative() { return number(model::not_negative); }

Form ring() {
  const std::vector<std::string> rest{"radius_m"};
  Choice choice{{{{"geometry"}, {}}}};
  for (const std::string_view stiffness : stiffness_keys)
    choice.ways.push_back({{"modal_mass_kg", "thickness_ratio", std::string(stiffness)}, rest});
  return map_of(
      {must("nodal_diameters", form_of(nodal_diameters), "n of the ring's in-plane mode"),
       must("geometry", map_of(keys_of<rubsweep::ring::RingGeometry>()),
            "dimensions and material, instead of modal data"),
       must("modal_mass_kg", positive(), "modal mass"),
       must("thickness_ratio", number(thickness_ratios), "thickness over radius"),
       may("radius_m", positive(), "radius, for the static load and for beams by geometry", "(none)"),
       must(std::string(stiffness_keys[0]), positive(), "modal stiffness"),
       must(std::string(stiffness_keys[1]), positive(),
            "natural frequency of the mode, instead of its stiffness"),
       must(std::string(stiffness_keys[2]), positive(), "the same as an angular frequency")},
      {std::move(choice)});
}

std::vector<Key> common(std::string_view kind) {
  return {
      must("kind", one_of({&kind, 1}), "kind of load: spring_mass or beam"),
      must("angle_deg", number({}), "place on the ring"),
      may("inclination_deg", number(inclinations), "inclination against the radius, with motion: both", "0"),
      may("motion", one_of(motions.texts), "motions that the load has", "both")};
}

Form spring_mass() {
  const Condition radial{"motion", {"both", "radial"}, true},
      tangential{"motion", {"both", "tangential"}, true};
  return map_of(joined(
      {common(kinds[0]),
       {must("mass_kg", not_negative(), "mass; above 0 unless it moves radially alone"),
        beside(must("radial_stiffness_n_per_m", not_negative(), "radial stiffness"), radial),
        beside(must("tangential_stiffness_n_per_m", positive(), "tangential stiffness"), tangential)}}));
}

Form beam() {
  return map_of(
      joined({common(kinds[1]),
              {must("geometry", map_of(keys_of<rubsweep::ring::BeamGeometry>()),
                    "section and material, instead of modal data"),
               must("radial_mass_kg", positive(), "modal mass of the radial motion"),
               must("flexural_mass_kg", positive(), "modal mass of bending"),
               may("rotary_mass_kg", not_negative(), "modal mass of rotation", "(of a beam)"),
               must("radial_stiffness_n_per_m", not_negative(), "radial stiffness"),
               must("tangential_stiffness_n_per_m", positive(), "stiffness of bending")}}),
      {{{{{"geometry"}, {}},
         {{"radial_mass_kg", "flexural_mass_kg", "radial_stiffness_n_per_m", "tangential_stiffness_n_per_m"},
          {"rotary_mass_kg"}}}}});
}

Form chart_form() {
  return map_of({must("parameter", one_of(parameters.texts), "what changes beside the speed"),
                 may("load", integer(0, static_cast<long>(max_ring_loads) - 1),
                     "number of the load that it is of", "(all)"),
                 must("over", study::axis_form({}), "its values")});
}

}  // namespace

rubsweep::ring::ChartAxis read_ring_chart(const yaml::Value& value,
                                          const std::vector<rubsweep::ring::Load>& loads) {
  yaml::Section section(value, "a map with parameter, load, over");
  rubsweep::ring::ChartAxis axis;
  if (section.require("parameter", yaml::describe(parameters.texts))) {
    section.field("parameter", axis.parameter, parameters);
  }
  if (const auto load = section.find("load")) {
    const auto index = read_integer(*load, {0, std::max<long>(0, static_cast<long>(loads.size()) - 1)});
    if (index) axis.load = static_cast<std::size_t>(*index);
    if (axis.parameter == Parameter::friction_coefficient) {
      refuse(*load, "given beside parameter: friction_coefficient", "nothing, all loads rub alike");
    }
  }
  if (const auto over = section.require("over", study::axis_forms)) {
    study::AxisValues read = study::read_axis(*over, ranges[static_cast<std::size_t>(axis.parameter)]);
    axis.values = std::move(read.values);
    axis.spacing = read.spacing;
  }
  section.refuse_unknown_keys();
  if (!section.is_sound()) return axis;
  for (std::size_t j = 0; j < loads.size(); ++j) {
    const bool varies = !axis.load || *axis.load == j;
    if (varies && !knows(loads[j], axis.parameter)) {
      section.refuse_together("parameter", {"parameter", "load"},
                              "load " + std::to_string(j) + " does not have it by its motion",
                              "a parameter of loads that move so");
    }
  }
  return axis;
}

void print_ring_chart(yaml::Printer& printer, const rubsweep::ring::ChartAxis& axis, study::AxisPrint how) {
  printer.open("chart");
  printer.field("parameter", axis.parameter, parameters);
  if (axis.load) printer.integer("load", static_cast<long>(*axis.load));
  printer.open("over");
  study::print_axis_values(printer, axis.values,
                           how == study::AxisPrint::as_written ? axis.spacing : std::nullopt);
  printer.close();
  printer.close();
}

RingConfig read_ring_config(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_ring_config_text(yaml::read_config_bytes(file), file.string(), overrides);
}

RingConfig read_ring_config_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides) {
  yaml::Diagnostics diagnostics(name, overrides);
  static const yaml::Alternatives alternatives(ring_form());
  const yaml::Node root = parse_config(text, name, root_form, overrides, diagnostics, alternatives);
  refuse_foreign(root, {"rotor", "stops"}, {"ring", "loads"}, "rubsweep", diagnostics);
  RingConfig config = read_sections({root, "", diagnostics});
  if (diagnostics.count() == 0) refuse_unit_slips({root, "", diagnostics}, nullptr);
  diagnostics.throw_if_any();
  config.questions = unit_questions({root, "", diagnostics}, nullptr);
  return config;
}

std::string print_ring_config(const RingConfig& config) {
  yaml::Printer printer;
  print_captions(printer, config.captions);
  print(printer, config.study, study::AxisPrint::as_written);
  print_output(printer, config.output_directory);
  return printer.yaml();
}

std::string ring_study_digest(const rubsweep::ring::Study& study) {
  yaml::Printer printer;
  print(printer, study, study::AxisPrint::by_value);
  return digest_of(printer.yaml());
}

Form ring_form() {
  return map_of(
      joined({caption_keys(),
              {base_of_map(), must("ring", ring(), "the elastic ring"),
               must("loads", list_of(any_of({spring_mass(), beam()}), 1, max_ring_loads),
                    "loads that rub on the ring"),
               must("friction_coefficient", not_negative(), "friction coefficient of all loads"),
               may("preload_n", not_negative(), "force with which each load is pressed outward at rest", "0"),
               must("speed_rpm", study::axis_form(speeds_rpm), "speeds, in revolutions per minute"),
               may("chart", chart_form(), "a second parameter, for a chart of stability", "(none)"),
               must("output", output_form(), "where results go")}}));
}

}  // namespace rubsweep::config::ring
