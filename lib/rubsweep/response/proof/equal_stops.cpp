#include "rubsweep/response/proof/equal_stops.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/contact/wall.hpp"
#include "rubsweep/scene/quiet_motion.hpp"

namespace rubsweep::response::proof {
namespace {

std::vector<double> numbers_of(const model::Friction& friction) {
  std::vector<double> numbers;
  std::visit(
      [&numbers](const auto& law) {
        law.visit_fields(law, [&numbers](auto&&, double value, auto&&) { numbers.push_back(value); });
      },
      friction);
  return numbers;
}

bool same_friction(const model::Friction& a, const model::Friction& b) {
  return a.index() == b.index() && numbers_of(a) == numbers_of(b);
}

bool equal(const structure::LinearSystem& structure, const scene::Contact& a, const scene::Contact& b) {
  return !a.casing_point && !b.casing_point &&
         scene::relative_map(structure, a) == scene::relative_map(structure, b) &&
         contact::same(a.wall, b.wall) && a.clearance_m == b.clearance_m &&
         a.damping_ns_per_m * b.stiffness_n_per_m == b.damping_ns_per_m * a.stiffness_n_per_m &&
         a.surface_speed_m_per_s == b.surface_speed_m_per_s && same_friction(a.friction, b.friction);
}

}  // namespace

scene::Scene with_equal_stops_as_one(scene::Scene scene) {
  // The numbers of torsion go by contact.
  if (scene.twist) return scene;
  std::vector<scene::Contact> distinct;
  for (const scene::Contact& contact : scene.contacts) {
    const auto found = std::ranges::find_if(
        distinct, [&](const scene::Contact& other) { return equal(scene.structure, contact, other); });
    if (found == distinct.end()) {
      distinct.push_back(contact);
    } else {
      found->stiffness_n_per_m += contact.stiffness_n_per_m;
      found->damping_ns_per_m += contact.damping_ns_per_m;
    }
  }
  scene.contacts = std::move(distinct);
  return scene;
}

}  // namespace rubsweep::response::proof
