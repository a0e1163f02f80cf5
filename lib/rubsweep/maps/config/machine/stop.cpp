#include "rubsweep/maps/config/machine/stop.hpp"

#include <fmt/format.h>

#include <array>
#include <variant>

#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view rigid = "rigid";
constexpr std::string_view casing_forms = "rigid, or a map with mass_kg, stiffness_n_per_m, damping_ratio";

/// Reads `casing` of a stop: {mass_kg, stiffness_n_per_m, damping_ratio}, all required, or the word `rigid`,
/// for which the result is empty.
std::optional<model::Casing> read_casing(const yaml::Value& value) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    read_word(value, {&rigid, 1}, casing_forms);
    return std::nullopt;
  }
  model::Casing casing;
  read_map(value, casing, casing_forms);
  return casing;
}

constexpr std::string_view stiffness_key = "stiffness_n_per_m";
constexpr std::string_view hertz_key = "hertz";

/// Calls `visit` with each kind of stop.
void for_each_kind(const auto& visit) {
  [&]<class... Kinds>(const std::variant<Kinds...>&) { (visit(Kinds{}), ...); }(model::StopGeometry{});
}

std::vector<std::string_view> stop_kinds() {
  std::vector<std::string_view> names;
  for_each_kind([&]<class Kind>(const Kind&) { names.push_back(Kind::name); });
  return names;
}

model::StopGeometry read_geometry(yaml::Section& section) {
  model::StopGeometry geometry;
  const std::vector<std::string_view> kinds = stop_kinds();
  const auto chosen = section.require_kind("kind", kinds);
  for_each_kind([&]<class Kind>(Kind kind) {
    if (!chosen) {
      // Without a kind it is unknown which keys belong here: these are neither required nor refused.
      Kind::visit_fields(kind, [&](std::string_view name, auto&, const auto&) { section.find(name); });
    } else if (kinds[*chosen] == Kind::name) {
      read_fields(section, kind);
      geometry = kind;
    }
  });
  return geometry;
}

void refuse_unfitting(const yaml::Section& section, const model::Stop& stop) {
  if (const auto problem =
          std::visit([&](const auto& kind) { return kind.problem(stop.clearance_m); }, stop.geometry))
    section.refuse(problem->key, problem->wrong, problem->allowed);
}

template <class... Dampings>
model::ContactDamping read_damping(yaml::Section& section, std::variant<Dampings...> damping) {
  const std::array names{model::name_of<Dampings>()...};
  section.require_exactly_one(names);
  const auto read = [&]<class Damping>(Damping given) {
    if (section.find(model::name_of<Damping>())) read_fields(section, given), damping = given;
  };
  (read(Dampings{}), ...);
  return damping;
}

/// Reads `hertz`; empty after it added a problem.
std::optional<model::HertzLine> read_hertz(const yaml::Value& value) {
  yaml::Section section(value);
  model::HertzLine contact;
  model::HertzLine::visit_keys(contact, section);
  if (contact.casing_shape == model::HertzShape::hole && contact.casing.radius_m <= contact.rotor.radius_m) {
    yaml::refuse(
        {*find_node(value.node, "casing.radius_m"), value.path + ".casing.radius_m", value.diagnostics},
        "the rotor does not fit into the hole", "a number above the rotor's radius_m");
  }
  section.refuse_unknown_keys();
  if (!section.is_sound()) return std::nullopt;
  if (contact.length_m < 2 * contact::hertz_half_width_m(contact, contact.design_force_n)) {
    section.refuse("design_force_n", "the contact is wider than long",
                   "a smaller force or a greater length_m");
    return std::nullopt;
  }
  return contact;
}

constexpr std::string_view law_key = "law", linear = "linear";
constexpr std::string_view law_forms = "linear, or a map with kind";

/// Reads `law`: a map, or the word `linear`.
model::NormalLaw read_law(const yaml::Value& value) {
  model::NormalLaw law;
  if (value.node.kind == yaml::Node::Kind::scalar) {
    read_word(value, {&linear, 1}, law_forms);
    return law;
  }
  yaml::Section section(value, law_forms);
  model::NormalLaw::visit_keys(law, section);
  section.refuse_unknown_keys();
  if (law.kind != model::ForceCurve::table || !section.is_sound()) return law;
  if (const auto problem = model::problem_of_curve(law))
    section.refuse(problem->key, problem->wrong, problem->allowed);
  return law;
}

/// Reads keys of a linear contact that stand beside another force law. The secant stiffness of this law
/// becomes the stiffness of the stop.
void fit_to_law(yaml::Section& section, model::Stop& stop) {
  for (const std::string_view name :
       {stiffness_key, model::name_of<model::NominalRestitution>(),
        model::name_of<model::RestitutionByRotorMass>(), model::name_of<model::DeliveredRestitution>(),
        model::name_of<model::ExplicitDamping>()}) {
    if (section.find(name))
      section.refuse_together(law_key, {law_key, name}, fmt::format("given beside {}", name),
                              "a linear law, or the keys of law alone");
  }
  if (section.find("contact_mass_kg"))
    section.refuse_together(law_key, {law_key, "contact_mass_kg"}, "asks for no mass",
                            "a law without contact_mass_kg");
  const bool of_hertz = stop.law.kind == model::ForceCurve::hertz_line;
  if (of_hertz != section.find(hertz_key).has_value())
    section.refuse_together(law_key, {law_key, hertz_key},
                            of_hertz ? "hertz_line needs the line contact" : "given beside hertz",
                            of_hertz ? "kind: hertz_line beside hertz" : "kind: hertz_line, or no hertz");
  stop.stiffness_n_per_m = section.is_sound() ? contact::secant_n_per_m(stop) : 1;
  if (!model::contains(model::positive, stop.stiffness_n_per_m))
    section.refuse(law_key,
                   fmt::format("gives {:.4g} N/m at a twentieth of the clearance", stop.stiffness_n_per_m),
                   model::describe(model::positive, stop.stiffness_n_per_m));
}

/// Reads the contact stiffness, or computes it from hertz or from another law.
void read_contact(yaml::Section& section, model::Stop& stop) {
  if (const auto law = section.find(law_key)) stop.law = read_law(*law);
  const auto hertz = section.find(hertz_key);
  if (hertz) {
    stop.hertz = read_hertz(*hertz);
    stop.stiffness_n_per_m = stop.hertz ? contact::hertz_stiffness_n_per_m(*stop.hertz) : 1;
    if (!model::contains(model::positive, stop.stiffness_n_per_m)) {
      section.refuse(hertz_key, fmt::format("gives a stiffness of {:.4g} N/m", stop.stiffness_n_per_m),
                     model::describe(model::positive, stop.stiffness_n_per_m));
    }
  }
  model::Stop::visit_fields(stop, [&](std::string_view name, double& field, const model::Range& range) {
    if (name == stiffness_key && !stop.law.linear()) return;
    if (name != stiffness_key || !hertz) {
      section.field(name, field, range);
    } else if (section.find(stiffness_key)) {
      section.refuse_together(hertz_key, {hertz_key, stiffness_key}, "given beside stiffness_n_per_m",
                              "one of the two");
    }
  });
  if (!stop.law.linear()) fit_to_law(section, stop);
}

void print_contact(yaml::Printer& printer, const model::Stop& stop) {
  model::Stop::visit_fields(stop, [&](std::string_view name, double field, const model::Range& range) {
    if (name == stiffness_key && !stop.law.linear())
      printer.map(law_key, "", [&](auto& keys) { model::NormalLaw::visit_keys(stop.law, keys); });
    if (name == stiffness_key && stop.hertz) {
      printer.map(hertz_key, "", [&](auto& keys) { model::HertzLine::visit_keys(*stop.hertz, keys); });
    } else if (name != stiffness_key || stop.law.linear()) {
      printer.field(name, field, range);
    }
  });
}

model::Stop read_stop(const yaml::Value& value, const std::optional<model::Range>& places,
                      std::string& name) {
  yaml::Section section(value);
  model::Stop stop;
  stop.geometry = read_geometry(section);
  if (places) {
    double position_m = model::required;
    section.field("position_m", position_m, *places);
    stop.position_m = position_m;
  }
  read_contact(section, stop);
  refuse_unfitting(section, stop);
  if (stop.law.linear()) {
    stop.damping = read_damping(section, stop.damping);
    model::Stop::visit_mass(stop, model::fields_into(section));
  }
  if (const auto friction = section.find("friction")) stop.friction = read_friction(*friction);
  if (const auto casing = section.find("casing")) stop.casing = read_casing(*casing);
  if (const auto given = section.find("name")) name = read_text(*given).value_or("");
  return stop;
}

void print_stop(yaml::Printer& printer, const model::Stop& stop, const std::string& name) {
  printer.open_item();
  printer.word("kind", model::name_of(stop.geometry));
  std::visit([&](const auto& kind) { print_fields(printer, kind); }, stop.geometry);
  printer.field("position_m", stop.position_m, model::any_finite);
  print_contact(printer, stop);
  if (stop.law.linear())
    std::visit([&](const auto& damping) { print_fields(printer, damping); }, stop.damping);
  model::Stop::visit_mass(stop, model::fields_into(printer));
  print_friction(printer, stop.friction);
  stop.casing ? print_map(printer, "casing", *stop.casing) : printer.word("casing", rigid);
  if (!name.empty()) printer.text("name", name);
  printer.close();
}

}  // namespace

std::vector<model::Stop> read_stops(const yaml::Value& value, const std::optional<model::Range>& places,
                                    std::vector<std::string>& names) {
  std::vector<model::Stop> stops;
  for (const yaml::Value& item : read_list(value, max_stops))
    stops.push_back(read_stop(item, places, names.emplace_back()));
  return stops;
}

keys::Form stops_form() {
  using namespace keys;
  const KeysOf<model::ContactDamping> damping;
  const std::string law(law_key);
  Choice damped = choice_of(damping.ways);
  for (Way& way : damped.ways) way.optional.push_back(law);
  damped.ways.push_back({{law}, {}});
  damped.replaces = law;
  return list_of(
      map_of(joined({{must("kind", one_of(stop_kinds()), "flat wall, or a round wall around the rotor")},
                     keys_by([](Table& table) {
                       for_each_kind([&]<class Kind>(const Kind& kind) {
                         table.beside("kind", {std::string(Kind::name)}, true,
                                      [&] { Kind::visit_fields(kind, model::fields_into(table)); });
                       });
                     }),
                     {may("position_m", number(model::not_negative),
                          "place along the shaft, of a rotor kit only", "(required of a kit)")},
                     keys_of<model::Stop>(),
                     {must(std::string(hertz_key), map_of(keys_of<model::HertzLine>()),
                           "line contact of Hertz that the stiffness follows from"),
                      newer_key(may(law, any_of({one_of({&linear, 1}), map_of(keys_of<model::NormalLaw>())}),
                                    "normal force over penetration", std::string(linear)))},
                     joined(damping.ways),
                     keys_by([](Table& table) {
                       const model::Stop defaults;
                       model::Stop::visit_mass(defaults, model::fields_into(table));
                     }),
                     {may("friction", friction_form(), "friction of the surfaces", "none"),
                      may("casing", any_of({one_of({&rigid, 1}), map_of(keys_of<model::Casing>())}),
                          "casing behind the stop", "rigid"),
                      name_key()}}),
             {Choice{{{{std::string(stiffness_key)}, {law}},
                      {{std::string(hertz_key)}, {law}},
                      {{law}, {std::string(hertz_key)}}},
                     false,
                     law},
              damped}),
      1, max_stops);
}

void print_stops(yaml::Printer& printer, const std::vector<model::Stop>& stops,
                 const std::vector<std::string>& names) {
  printer.open("stops");
  for (std::size_t i = 0; i < stops.size(); ++i) print_stop(printer, stops[i], model::name_at(names, i));
  printer.close();
}

}  // namespace rubsweep::config::machine
