#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/maps/config/keys/fields.hpp"
#include "rubsweep/maps/config/keys/machine_form.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"

namespace rubsweep::config::keys {
namespace {

std::vector<Key> material() {
  const model::HertzBody body;
  std::vector<Key> keys;
  model::HertzBody::visit_material(body, [&](std::string_view name, double, const model::Range& range) {
    keys.push_back(must(std::string(name), number(range),
                        name == "poisson_ratio" ? "Poisson's ratio" : "Young's modulus"));
  });
  return keys;
}

Form casing_form() {
  return any_of(
      {word({"rigid"}), map_of(fields_of<model::Casing>(
                            {{"mass_kg", "mass of the casing"},
                             {"stiffness_n_per_m", "stiffness of its mount, the same in x and y"},
                             {"damping_ratio", "damping of its mount as a fraction of critical damping"}}))});
}

std::vector<Key> damping_keys() {
  const Form restitution = number(model::Stop::restitution_range);
  Key by_rotor_mass = must("restitution_by_rotor_mass", restitution,
                           "the same with the mass of the rotor alone in d = 2 zeta sqrt(m K)");
  by_rotor_mass.since = "0.1.0+";
  return {must("restitution", restitution, "nominal restitution, from which the damping constant follows"),
          std::move(by_rotor_mass),
          must("restitution_delivered", number(model::Stop::restitution_delivered_range),
               "restitution that a free impact really has"),
          must("damping_ns_per_m", number(model::not_negative), "damping constant of the contact itself")};
}

}  // namespace

Form hertz_form() {
  const Condition round{"shape", {"cylinder", "hole"}, true};
  return map_of(
      {must("length_m", number(model::positive), "length of the contact along the shaft"),
       must("rotor",
            map_of(joined(
                {{must("radius_m", number(model::positive), "radius of the rotor's surface")}, material()})),
            "surface of the rotor"),
       must("casing",
            map_of(joined(
                {{may("shape", word({"cylinder", "flat", "hole"}), "shape of the casing's surface",
                      "cylinder"),
                  beside(must("radius_m", number(model::positive), "radius of the casing's surface"), round)},
                 material()})),
            "surface of the casing"),
       must("design_force_n", number(model::positive), "force at which the stiffness is the secant"),
       may("half_width", word({"textbook", "paper"}), "formula of the width of the contact", "textbook")});
}

Form friction_form() {
  std::vector<Key> keys{must("stribeck", list_of(number(model::any_finite), 6, 6),
                             "g1 to g6 of mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v"),
                        must("coefficient", number(model::ConstantFriction::coefficient_range),
                             "dry friction, against the slip; it holds the surfaces together where it can")};
  Key one_way = must("one_way", number(model::ConstantFriction::coefficient_range),
                     "friction in the direction of shaft rotation whatever the slip");
  one_way.since = "0.1.0+";
  keys.push_back(std::move(one_way));
  for (Key& key :
       fields_of<model::StribeckCurve>({{"static", "largest coefficient of a measured curve"},
                                        {"kinetic", "coefficient behind the fall"},
                                        {"peak_speed_m_per_s", "slip speed of the largest coefficient"},
                                        {"settle_speed_m_per_s", "slip speed at which the fall has ended"},
                                        {"viscous_s_per_m", "slope of the coefficient beyond"}}))
    keys.push_back(std::move(key));
  return any_of(
      {word({"none"}),
       map_of(std::move(keys), {{{{{"coefficient"}, {}},
                                  {{"one_way"}, {}},
                                  {{"stribeck"}, {}},
                                  {{"static", "kinetic", "peak_speed_m_per_s", "settle_speed_m_per_s"},
                                   {"viscous_s_per_m"}}}}})});
}

Form stops_form() {
  const Condition flat{"kind", {"one_side"}}, round{"kind", {"annular"}};
  std::vector<Key> contact = fields_of<model::Stop>(
      {{"clearance_m", "travel of the rotor from its unloaded position to the first touch"},
       {"stiffness_n_per_m", "stiffness of the contact"},
       {"contact_radius_m", "radius of the surface that rubs; its speed is this times the shaft speed"}});
  std::vector<Key> keys =
      joined({{must("kind", word({"one_side", "annular"}), "flat wall, or a round wall around the rotor"),
               beside(must("angle_deg", number(model::any_finite),
                           "direction from the rest position to the wall, from +x towards +y"),
                      flat),
               beside(may("offset_m", list_of(number(model::any_finite), 2, 2),
                          "[x, y] of the rotor's rest position against the centre of the stop", "[0, 0]"),
                      round),
               may("position_m", number(model::not_negative), "place along the shaft, of a rotor kit only",
                   "(required of a kit)")},
              std::move(contact),
              {must("hertz", hertz_form(), "line contact of Hertz that the stiffness follows from")},
              damping_keys(),
              {may("contact_mass_kg", number(model::positive),
                   "mass behind a restitution, before it is reduced with the casing's",
                   "(mass of the Jeffcott rotor, or modal mass of a kit's first mode)"),
               may("friction", friction_form(), "friction of the surfaces", "none"),
               may("casing", casing_form(), "casing behind the stop", "rigid")}});
  Choice stiffness{{{{"stiffness_n_per_m"}, {}}, {{"hertz"}, {}}}};
  Choice damping{{{{"restitution"}, {}},
                  {{"restitution_by_rotor_mass"}, {}},
                  {{"restitution_delivered"}, {}},
                  {{"damping_ns_per_m"}, {}}}};
  return list_of(map_of(std::move(keys), {std::move(stiffness), std::move(damping)}), 1, machine::max_stops);
}

}  // namespace rubsweep::config::keys
