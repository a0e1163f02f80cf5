#include <numbers>

#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/ring/read_ring_config.hpp"

namespace rubsweep::config::ring {
namespace {

using rubsweep::ring::Load;
using rubsweep::ring::LoadKind;
using rubsweep::ring::Motion;

Load read_spring_mass(yaml::Section& section, Motion motion) {
  double mass = model::required, radial = model::required, tangential = model::required;
  section.field("mass_kg", mass, motion == Motion::radial ? model::not_negative : model::positive);
  if (motion == Motion::tangential) radial = 0;
  if (motion == Motion::radial) tangential = 0;
  if (motion != Motion::tangential) section.field("radial_stiffness_n_per_m", radial, model::not_negative);
  if (motion != Motion::radial) section.field("tangential_stiffness_n_per_m", tangential, model::positive);
  return rubsweep::ring::spring_mass(mass, radial, tangential);
}

Load read_beam_geometry(const yaml::Value& value, const std::optional<double>& ring_radius_m) {
  yaml::Section section(value);
  rubsweep::ring::BeamGeometry geometry;
  read_fields(section, geometry);
  section.refuse_unknown_keys();
  if (!ring_radius_m) refuse(value, "needs the length of the beam", "beside ring.radius_m");
  if (!section.is_sound()) return {};
  return rubsweep::ring::beam(geometry, *ring_radius_m);
}

Load read_beam(yaml::Section& section, const std::optional<double>& ring_radius_m) {
  if (const auto geometry = section.find("geometry")) return read_beam_geometry(*geometry, ring_radius_m);
  double radial_mass = model::required, flexural_mass = model::required;
  double radial = model::required, tangential = model::required;
  std::optional<double> rotary_mass;
  section.field("radial_mass_kg", radial_mass, model::positive);
  section.field("flexural_mass_kg", flexural_mass, model::positive);
  section.field("rotary_mass_kg", rotary_mass, model::not_negative);
  section.field("radial_stiffness_n_per_m", radial, model::not_negative);
  section.field("tangential_stiffness_n_per_m", tangential, model::positive);
  if (!section.is_sound()) return {};
  Load load = rubsweep::ring::beam(radial_mass, flexural_mass, radial, tangential);
  if (rotary_mass) load.rotary_mass_kg = *rotary_mass;
  if (!(load.rotary_mass_kg >= 0 && load.rotary_mass_kg < flexural_mass)) {
    section.refuse_together("rotary_mass_kg", {"rotary_mass_kg", "radial_mass_kg", "flexural_mass_kg"},
                            std::to_string(load.rotary_mass_kg) + " kg belong to these masses",
                            "from 0 to below flexural_mass_kg");
  }
  return load;
}

Load read_load(const yaml::Value& value, const std::optional<double>& ring_radius_m) {
  yaml::Section section(value);
  const auto kind = section.require_kind("kind", kinds);
  double angle = model::required, inclination = 0;
  Motion motion = Motion::both;
  section.field("angle_deg", angle, model::any_finite);
  section.field("inclination_deg", inclination, inclinations);
  section.field("motion", motion, motions);
  if (motion != Motion::both && inclination != 0) {
    section.refuse_together("inclination_deg", {"inclination_deg", "motion"},
                            "a load with one motion has no inclination", "0, or motion: both");
  }
  Load load;
  if (kind) load = *kind == 0 ? read_spring_mass(section, motion) : read_beam(section, ring_radius_m);
  load.angle_deg = angle;
  load.inclination_deg = inclination;
  load.motion = motion;
  // Without a kind the allowed keys are unknown.
  if (!kind) section.allow_unknown_keys();
  return load;
}

void print_stiffnesses(yaml::Printer& printer, const Load& load) {
  const bool beam = load.kind == LoadKind::beam;
  if (beam || load.motion != Motion::tangential) {
    printer.number("radial_stiffness_n_per_m", load.radial_stiffness_n_per_m);
  }
  if (beam || load.motion != Motion::radial) {
    printer.number("tangential_stiffness_n_per_m", load.tangential_stiffness_n_per_m);
  }
}

rubsweep::ring::Ring read_geometry(const yaml::Value& value, int diameters) {
  yaml::Section section(value);
  rubsweep::ring::RingGeometry geometry;
  read_fields(section, geometry);
  section.refuse_unknown_keys();
  if (!section.is_sound()) return {};
  if (geometry.thickness_m >= geometry.radius_m) {
    section.refuse_together("thickness_m", {"thickness_m", "radius_m"}, "is not below radius_m",
                            "a thin ring");
  }
  return rubsweep::ring::ring(geometry, diameters);
}

rubsweep::ring::Ring read_modal(yaml::Section& section, int diameters) {
  rubsweep::ring::Ring ring{diameters, model::required, 0, model::required, {}};
  section.field("modal_mass_kg", ring.modal_mass_kg, model::positive);
  section.field("thickness_ratio", ring.thickness_ratio, thickness_ratios);
  section.field("radius_m", ring.radius_m, model::positive);
  section.require_exactly_one(stiffness_keys);
  std::optional<double> stiffness, hertz, radians;
  section.field("modal_stiffness_n_per_m", stiffness, model::positive);
  section.field("natural_frequency_hz", hertz, model::positive);
  section.field("natural_frequency_rad_per_s", radians, model::positive);
  if (!section.is_sound()) return {};
  if (hertz) radians = 2 * std::numbers::pi * *hertz;
  ring.modal_stiffness_n_per_m =
      stiffness ? *stiffness
                : rubsweep::ring::stiffness_of_frequency(*radians, ring.modal_mass_kg, diameters);
  return ring;
}

}  // namespace

std::vector<Load> read_ring_loads(const yaml::Value& value, const std::optional<double>& ring_radius_m) {
  std::vector<Load> loads;
  for (const yaml::Value& item : read_list(value, max_ring_loads))
    loads.push_back(read_load(item, ring_radius_m));
  return loads;
}

void print_ring_loads(yaml::Printer& printer, const std::vector<Load>& loads) {
  printer.open("loads");
  for (const Load& load : loads) {
    printer.open_item();
    printer.word("kind", kinds[load.kind == LoadKind::beam ? 1 : 0]);
    printer.number("angle_deg", load.angle_deg);
    printer.number("inclination_deg", load.inclination_deg);
    printer.field("motion", load.motion, motions);
    if (load.kind == LoadKind::beam) {
      printer.number("radial_mass_kg", load.radial_mass_kg);
      printer.number("flexural_mass_kg", load.flexural_mass_kg);
      printer.number("rotary_mass_kg", load.rotary_mass_kg);
    } else {
      printer.number("mass_kg", load.radial_mass_kg);
    }
    print_stiffnesses(printer, load);
    printer.close();
  }
  printer.close();
}

rubsweep::ring::Ring read_ring(const yaml::Value& value) {
  yaml::Section section(value);
  int diameters = 2;
  if (section.require("nodal_diameters", yaml::describe(nodal_diameters))) {
    section.field("nodal_diameters", diameters, nodal_diameters);
  }
  rubsweep::ring::Ring ring;
  if (const auto geometry = section.find("geometry")) {
    ring = read_geometry(*geometry, diameters);
  } else {
    ring = read_modal(section, diameters);
  }
  return ring;
}

void print_ring(yaml::Printer& printer, const rubsweep::ring::Ring& ring) {
  printer.open("ring");
  printer.integer("nodal_diameters", ring.nodal_diameters);
  printer.number("modal_mass_kg", ring.modal_mass_kg);
  printer.number("modal_stiffness_n_per_m", ring.modal_stiffness_n_per_m);
  printer.number("thickness_ratio", ring.thickness_ratio);
  if (ring.radius_m) printer.number("radius_m", *ring.radius_m);
  printer.close();
}

}  // namespace rubsweep::config::ring
