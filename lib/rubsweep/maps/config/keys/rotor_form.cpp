#include "rubsweep/core/model/rotor.hpp"
#include "rubsweep/maps/config/keys/fields.hpp"
#include "rubsweep/maps/config/keys/machine_form.hpp"

namespace rubsweep::config::keys {

Form rotor_form() {
  const char* meaning =
      "kind of rotor: one disc on a massless shaft (jeffcott), a shaft line, a file of ROSS, or matrices";
  std::vector<Key> jeffcott = fields_of<model::JeffcottRotor>(
      {{"mass_kg", "mass of the disc: the modal mass there"},
       {"natural_frequency_hz", "undamped natural frequency, sqrt(k/m)/(2 pi)"},
       {"damping_ratio", "damping as a fraction of critical damping, c / (2 sqrt(k m)); of a kit by mode"},
       {"rotating_damping_ratio",
        "the same of the damping that turns with the shaft, in its material and joints"}});
  jeffcott.back().since = "0.1.0+";
  for (Key& key :
       newer({must("stiffness_n_per_m", number(model::positive), "stiffness of the shaft at the disc"),
              must("damping_ns_per_m", number(model::not_negative), "damping constant of the disc")}))
    jeffcott.push_back(std::move(key));
  const Choice frequency{{{{"natural_frequency_hz"}, {}}, {{"stiffness_n_per_m"}, {}}}},
      damping{{{{"damping_ratio"}, {}}, {{"damping_ns_per_m"}, {}}}};
  return any_of({map_of(joined({{must("kind", word({"jeffcott"}), meaning)}, std::move(jeffcott)}),
                        {frequency, damping}),
                 map_of(joined({{must("kind", word({"rotor_kit"}), meaning)}, rotor_kit_keys()})),
                 map_of(joined({{must("kind", word({"ross"}), meaning)}, ross_keys()})),
                 map_of(joined({{must("kind", word({"matrices"}), meaning)}, matrix_keys()}))});
}

}  // namespace rubsweep::config::keys
