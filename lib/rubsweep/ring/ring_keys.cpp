#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/ring/read_ring.hpp"
#include "rubsweep/ring/read_ring_config.hpp"

namespace rubsweep::config::ring {
namespace {

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
