#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <concepts>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/core/contact/friction_bounds.hpp"
#include "rubsweep/core/contact/stribeck_curve.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view none = "none";

/// Calls `visit` with each law but `none`.
void for_each_law(const auto& visit) {
  [&]<class... Laws>(const std::variant<model::NoFriction, Laws...>&) {
    (visit(Laws{}), ...);
  }(model::Friction{});
}

/// Whether a law is named by its first key. Three others are told apart by their further keys.
template <class Law>
constexpr bool named_by_first_key =
    !std::same_as<Law, model::StribeckFriction> && Law::at_rest != model::AtRest::holds_more;
template <class... Laws>
constexpr int laws_told_apart(const std::variant<model::NoFriction, Laws...>*) {
  return (static_cast<int>(!named_by_first_key<Laws>) + ...);
}
static_assert(laws_told_apart(static_cast<const model::Friction*>(nullptr)) == 3,
              "read_friction must tell apart laws that hold more");

std::vector<std::string_view> first_keys() {
  std::vector<std::string_view> names{"stribeck", "static"};
  for_each_law([&]<class Law>(const Law&) {
    if (named_by_first_key<Law>) names.push_back(model::name_of<Law>());
  });
  return names;
}

std::string friction_forms() {
  return fmt::format("none, or a map with one of {}", fmt::join(first_keys(), ", "));
}

model::StribeckFriction read_curve(yaml::Section& section) {
  model::StribeckCurve curve;
  read_fields(section, curve);
  if (!section.is_sound()) return {};
  if (curve.static_coefficient < curve.kinetic) {
    section.refuse_together("static", {"static", "kinetic"}, "below kinetic",
                            "a number no less than kinetic");
  } else if (curve.settle_speed_m_per_s <= 1.5 * curve.peak_speed_m_per_s) {
    section.refuse_together("settle_speed_m_per_s", {"settle_speed_m_per_s", "peak_speed_m_per_s"},
                            "too close to the peak", "more than 1.5 peak_speed_m_per_s");
  } else if (curve.settle_speed_m_per_s > contact::largest_settle_over_peak * curve.peak_speed_m_per_s) {
    section.refuse_together("settle_speed_m_per_s", {"settle_speed_m_per_s", "peak_speed_m_per_s"},
                            "too far from the peak", "at most 1e6 peak_speed_m_per_s");
  } else if (curve.viscous_s_per_m * curve.settle_speed_m_per_s > curve.kinetic) {
    section.refuse_together("viscous_s_per_m", {"viscous_s_per_m", "settle_speed_m_per_s", "kinetic"},
                            "more than all of the kinetic friction at the settling speed",
                            "a number <= kinetic / settle_speed_m_per_s");
  } else {
    try {
      return contact::stribeck_of(curve);
    } catch (const ConfigError&) {
      section.refuse_together("static", {"static", "kinetic", "peak_speed_m_per_s", "settle_speed_m_per_s"},
                              "no curve with these speeds and this kinetic coefficient has such a peak",
                              "a number that some curve reaches");
    }
  }
  return {};
}

/// Refuses a friction law, in either spelling, whose coefficient is negative or too large at some slip. A
/// negative coefficient would drive the slip.
void refuse_driving(const yaml::Section& section, std::string_view key, const model::Friction& friction) {
  const contact::FrictionBounds bounds = contact::friction_bounds(friction);
  if (contact::brakes(bounds)) return;
  section.refuse(
      key,
      bounds.smallest < 0
          ? fmt::format("gives a coefficient of {:.4g} at a slip of {:.4g} m/s, which drives the slip",
                        bounds.smallest, bounds.smallest_at_m_per_s)
          : fmt::format("gives a coefficient of {:.4g}", bounds.largest),
      fmt::format("a coefficient >= 0 at every slip and, without its viscous part, <= {}",
                  model::ConstantFriction::coefficient_range.high));
}

/// Reads a friction law whose static coefficient is larger than its sliding one.
template <class Law>
Law read_holding(yaml::Section& section) {
  Law law;
  read_fields(section, law);
  if (law.static_coefficient < law.coefficient)
    section.refuse_together("static", {"static", "coefficient"}, "below the sliding friction",
                            "a number no less than coefficient");
  return law;
}

}  // namespace

model::Friction read_friction(const yaml::Value& value) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    read_word(value, {&none, 1}, friction_forms());
    return model::NoFriction{};
  }
  yaml::Section section(value, friction_forms());
  model::Friction friction;
  const bool falls = section.holds("stribeck_speed_m_per_s") || section.holds("exponent");
  if (falls || (section.holds("static") && section.holds("coefficient") && !section.holds("kinetic"))) {
    section.require_exactly_one({"stribeck", "static", "one_way"});
    if (falls) {
      friction = read_holding<model::FallingFriction>(section);
    } else {
      friction = read_holding<model::StaticFriction>(section);
    }
    return friction;
  }
  section.require_exactly_one(first_keys());
  if (const auto stribeck = section.find("stribeck")) {
    if (read_numbers(*stribeck, friction.emplace<model::StribeckFriction>().gamma))
      refuse_driving(section, "stribeck", friction);
  }
  if (section.find("static")) {
    friction = read_curve(section);
    if (section.is_sound()) refuse_driving(section, "static", friction);
  }
  for_each_law([&]<class Law>(Law law) {
    if constexpr (named_by_first_key<Law>) {
      if (!section.find(model::name_of<Law>())) return;
      read_fields(section, law);
      friction = law;
      if (section.is_sound()) refuse_driving(section, model::name_of<Law>(), friction);
    }
  });
  return friction;
}

keys::Form friction_form() {
  using namespace keys;
  std::vector<std::vector<Key>> ways{
      {must("stribeck", list_of(number(model::any_finite), 6, 6),
            "g1 to g6 of mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v")}};
  for_each_law([&]<class Law>(const Law&) {
    using Curve = std::conditional_t<std::same_as<Law, model::StribeckFriction>, model::StribeckCurve, Law>;
    ways.push_back(keys_of<Curve>());
  });
  // A key that several laws have is listed only once.
  std::vector<Key> listed;
  for (Key& key : joined(ways)) {
    if (std::ranges::find(listed, key.name, &Key::name) == listed.end()) listed.push_back(std::move(key));
  }
  return any_of({one_of({&none, 1}), map_of(std::move(listed), {choice_of(ways)})});
}

void print_friction(yaml::Printer& printer, const model::Friction& friction) {
  const auto map = [&](const auto& print) {
    printer.open("friction");
    print();
    printer.close();
  };
  std::visit(overloaded{[&](const model::NoFriction&) { printer.word("friction", none); },
                        [&](const model::StribeckFriction& stribeck) {
                          map([&] {
                            if (stribeck.curve) return print_fields(printer, *stribeck.curve);
                            printer.numbers("stribeck", stribeck.gamma);
                          });
                        },
                        [&](const auto& law) { map([&] { print_fields(printer, law); }); }},
             friction);
}

}  // namespace rubsweep::config::machine
