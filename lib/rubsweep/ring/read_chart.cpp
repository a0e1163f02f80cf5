#include "rubsweep/ring/read_chart.hpp"

#include <algorithm>
#include <utility>

#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/ring/read_load.hpp"

namespace rubsweep::config::ring {
namespace {

using rubsweep::ring::Parameter;

constexpr yaml::Words<Parameter, 5> parameters{
    {"friction_coefficient", "angle_deg", "inclination_deg", "radial_stiffness_n_per_m",
     "tangential_stiffness_n_per_m"},
    {Parameter::friction_coefficient, Parameter::angle_deg, Parameter::inclination_deg,
     Parameter::radial_stiffness_n_per_m, Parameter::tangential_stiffness_n_per_m}};

model::Range range_of(Parameter parameter) {
  switch (parameter) {
    case Parameter::friction_coefficient:
    case Parameter::radial_stiffness_n_per_m:
      return model::not_negative;
    case Parameter::angle_deg:
      return model::any_finite;
    case Parameter::inclination_deg:
      return inclinations;
    case Parameter::tangential_stiffness_n_per_m:
      break;
  }
  return model::positive;
}

/// A parameter that a load's motion does not know would change nothing.
bool knows(const rubsweep::ring::Load& load, Parameter parameter) {
  if (parameter == Parameter::inclination_deg) return load.motion == rubsweep::ring::Motion::both;
  if (parameter == Parameter::radial_stiffness_n_per_m)
    return load.motion != rubsweep::ring::Motion::tangential;
  if (parameter == Parameter::tangential_stiffness_n_per_m)
    return load.motion != rubsweep::ring::Motion::radial;
  return true;
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
    study::AxisValues read = study::read_axis(*over, range_of(axis.parameter));
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

}  // namespace rubsweep::config::ring
