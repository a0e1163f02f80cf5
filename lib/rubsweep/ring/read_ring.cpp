#include "rubsweep/ring/read_ring.hpp"

#include <numbers>

#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::ring {
namespace {

constexpr yaml::IntegerRange nodal_diameters{2, 100};
constexpr model::Range thickness_ratios{.low = 0, .high = 1, .high_open = true};

rubsweep::ring::Ring read_geometry(const yaml::Value& value, int diameters) {
  yaml::Section section(value);
  rubsweep::ring::RingGeometry geometry{model::required, model::required, model::required, model::required,
                                        model::required};
  section.field("radius_m", geometry.radius_m, model::positive);
  section.field("thickness_m", geometry.thickness_m, model::positive);
  section.field("width_m", geometry.width_m, model::positive);
  section.field("density_kg_per_m3", geometry.density_kg_per_m3, model::positive);
  section.field("youngs_modulus_pa", geometry.youngs_modulus_pa, model::positive);
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
  section.require_exactly_one(
      {"modal_stiffness_n_per_m", "natural_frequency_hz", "natural_frequency_rad_per_s"});
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

rubsweep::ring::Ring read_ring(const yaml::Value& value) {
  yaml::Section section(value);
  int diameters = 2;
  if (section.require("nodal_diameters", describe(nodal_diameters))) {
    section.field("nodal_diameters", diameters, nodal_diameters);
  }
  rubsweep::ring::Ring ring;
  if (const auto geometry = section.find("geometry")) {
    ring = read_geometry(*geometry, diameters);
  } else {
    ring = read_modal(section, diameters);
  }
  section.refuse_unknown_keys();
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
