#include "rubsweep/maps/config/keys/ring_form.hpp"

#include "rubsweep/maps/config/keys/axis_form.hpp"
#include "rubsweep/maps/config/keys/fields.hpp"
#include "rubsweep/maps/config/keys/run_form.hpp"

namespace rubsweep::config::keys {
namespace {

constexpr std::size_t most_loads = 64;
constexpr model::Range inclinations{.low = -90, .high = 90};

Form positive() { return number(model::positive); }
Form not_negative() { return number(model::not_negative); }

Form ring() {
  Form geometry =
      map_of({must("radius_m", positive(), "mean radius"), must("thickness_m", positive(), "thickness"),
              must("width_m", positive(), "width"), must("density_kg_per_m3", positive(), "density"),
              must("youngs_modulus_pa", positive(), "Young's modulus")});
  std::vector<Key> keys{
      must("nodal_diameters", integer(2, 100), "n of the ring's in-plane mode"),
      must("geometry", std::move(geometry), "dimensions and material, instead of modal data"),
      must("modal_mass_kg", positive(), "modal mass"),
      must("thickness_ratio", number({.low = 0, .high = 1, .high_open = true}), "thickness over radius"),
      may("radius_m", positive(), "radius, for the static load and for beams by geometry", "(none)"),
      must("modal_stiffness_n_per_m", positive(), "modal stiffness"),
      must("natural_frequency_hz", positive(), "natural frequency of the mode, instead of its stiffness"),
      must("natural_frequency_rad_per_s", positive(), "the same as an angular frequency")};
  const std::vector<std::string> rest{"radius_m"};
  return map_of(std::move(keys),
                {{{{{"geometry"}, {}},
                   {{"modal_mass_kg", "thickness_ratio", "modal_stiffness_n_per_m"}, rest},
                   {{"modal_mass_kg", "thickness_ratio", "natural_frequency_hz"}, rest},
                   {{"modal_mass_kg", "thickness_ratio", "natural_frequency_rad_per_s"}, rest}}}});
}

std::vector<Key> common(const char* kind) {
  return {
      must("kind", word({kind}), "kind of load: spring_mass or beam"),
      must("angle_deg", number({}), "place on the ring"),
      may("inclination_deg", number(inclinations), "inclination against the radius, with motion: both", "0"),
      may("motion", word({"both", "radial", "tangential"}), "motions that the load has", "both")};
}

Form spring_mass() {
  const Condition radial{"motion", {"both", "radial"}, true},
      tangential{"motion", {"both", "tangential"}, true};
  return map_of(joined(
      {common("spring_mass"),
       {must("mass_kg", not_negative(), "mass; above 0 unless it moves radially alone"),
        beside(must("radial_stiffness_n_per_m", not_negative(), "radial stiffness"), radial),
        beside(must("tangential_stiffness_n_per_m", positive(), "tangential stiffness"), tangential)}}));
}

Form beam() {
  Form geometry = map_of({must("density_kg_per_m3", positive(), "density"),
                          must("section_area_m2", positive(), "area of the section"),
                          must("second_moment_m4", positive(), "second moment of area"),
                          must("youngs_modulus_pa", positive(), "Young's modulus")});
  return map_of(
      joined({common("beam"),
              {must("geometry", std::move(geometry), "section and material, instead of modal data"),
               must("radial_mass_kg", positive(), "modal mass of the radial motion"),
               must("flexural_mass_kg", positive(), "modal mass of bending"),
               may("rotary_mass_kg", not_negative(), "modal mass of rotation", "(of a beam)"),
               must("radial_stiffness_n_per_m", not_negative(), "radial stiffness"),
               must("tangential_stiffness_n_per_m", positive(), "stiffness of bending")}}),
      {{{{{"geometry"}, {}},
         {{"radial_mass_kg", "flexural_mass_kg", "radial_stiffness_n_per_m", "tangential_stiffness_n_per_m"},
          {"rotary_mass_kg"}}}}});
}

Form chart() {
  return map_of({must("parameter",
                      word({"friction_coefficient", "angle_deg", "inclination_deg",
                            "radial_stiffness_n_per_m", "tangential_stiffness_n_per_m"}),
                      "what changes beside the speed"),
                 may("load", integer(0, static_cast<long>(most_loads) - 1),
                     "number of the load that it is of", "(all)"),
                 must("over", axis({}), "its values")});
}

}  // namespace

Form ring_form() {
  return map_of(joined(
      {caption_keys(),
       {base_of_map(), must("ring", ring(), "the elastic ring"),
        must("loads", list_of(any_of({spring_mass(), beam()}), 1, most_loads), "loads that rub on the ring"),
        must("friction_coefficient", not_negative(), "friction coefficient of all loads"),
        may("preload_n", not_negative(), "force with which each load is pressed outward at rest", "0"),
        must("speed_rpm", axis({.low = 0, .high = 1e7}), "speeds, in revolutions per minute"),
        may("chart", chart(), "a second parameter, for a chart of stability", "(none)"),
        must("output", map_of({must("directory", text(), "directory of the results; --output goes first")}),
             "where results go")}}));
}

}  // namespace rubsweep::config::keys
