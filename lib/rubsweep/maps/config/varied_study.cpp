#include "rubsweep/maps/config/varied_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/machine/rotor.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/study/study.hpp"
#include "rubsweep/maps/config/study/sweep.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view allowed_keys =
    "a number of rotor, stops, kick, start, gravity_m_per_s2, solver or response, as --print-config names it";

/// Study as a YAML document, without the parts that an axis may not vary.
yaml::Node document_of(const sweep::Study& study) {
  sweep::Study plain = study;
  plain.threshold.reset();
  plain.basin.reset();
  // Two speeds suffice for the checks. The fastest may be too fast for a varied rotor; the slowest has the
  // longest run, which limits the kick.
  const auto [slowest, fastest] = std::ranges::minmax(study.grid.speed_hz);
  plain.grid = {.speed_hz = slowest < fastest ? std::vector{slowest, fastest} : std::vector{fastest},
                .measure = study.grid.measure,
                .unbalance = {study.grid.unbalance.front()}};
  yaml::Diagnostics diagnostics("the printed study", {});
  auto document = parse_document(print_study(plain), -1, "", diagnostics);
  diagnostics.throw_if_any();
  return *std::move(document);
}

/// The study after the numbers of `keys` were written over it. Problems with these numbers are reported at
/// `place`.
sweep::Study read_varied(yaml::Node document, std::span<const sweep::KeyValue> keys,
                         const yaml::SourcePosition& place, yaml::Diagnostics& diagnostics) {
  const std::size_t problems = diagnostics.count();
  for (const auto& [key, value] : keys)
    yaml::write_number(document, key, value, place, run_alternatives(), diagnostics);
  if (diagnostics.count() != problems) return {};
  const yaml::Value root{document, "", diagnostics};
  yaml::Section section(root);
  sweep::Study study = study::read_study(section);
  section.refuse_unknown_keys();
  if (diagnostics.count() == problems) refuse_unit_slips(root, &study.machine);
  return study;
}

void place_all(yaml::Node& node, const yaml::SourcePosition& place) {
  node.place = place;
  for (yaml::Node::Key& key : node.keys) key.place = place;
  for (yaml::Node& item : node.items) place_all(item, place);
}

bool holds_a_number(const yaml::Node& node) {
  return node.kind == yaml::Node::Kind::scalar && !node.quoted &&
         yaml::parse_number(node.text).error == yaml::NumberError::none;
}

bool is_part_of_the_mass(const std::string& key) {
  return key == "rotor.mass_kg" || key.starts_with("rotor.discs.") || key.starts_with("rotor.shaft.") ||
         key.starts_with("rotor.unbalance.");
}

/// Checks whether an axis may vary a key; if not, adds a problem and returns false. A key that is missing in
/// the document is accepted, as the printed study leaves out some keys. `by_mass`: key of the sweep that was
/// converted with the mass of the rotor, once for all cells.
bool may_be_swept(const yaml::Node& document, const std::string& key, std::string_view by_mass,
                  const yaml::SourcePosition& place, yaml::Diagnostics& diagnostics) {
  constexpr std::array<std::string_view, 6> own_axes{"speed_hz",           study::speed_rpm_key,
                                                     "whirl_ratio",        "eccentricity_m",
                                                     study::unbalance_key, study::grade_key};
  const std::string first = key.substr(0, key.find('.'));
  const auto problem = [&](std::string_view wrong, std::string_view allowed) {
    diagnostics.add(place, yaml::shown(key), wrong, allowed);
    return false;
  };
  if (std::ranges::find(own_axes, key) != own_axes.end())
    return problem("has an axis of its own", fmt::format("sweep.{}", key));
  if (first == "sweep" || first == "output" || first == "study" || first == "base")
    return problem("is no key of an axis", allowed_keys);
  if (!by_mass.empty() && is_part_of_the_mass(key))
    return problem(fmt::format("is part of the mass that sweep.{} takes its eccentricities from", by_mass),
                   "another key, or sweep.eccentricity_m or sweep.whirl_ratio");
  const yaml::Node* node = find_node(document, key);
  if (node != nullptr && !holds_a_number(*node))
    return problem(fmt::format("{}, no number", describe(*node)), allowed_keys);
  return true;
}

/// Constant (stiffness or damping) that was given for a Jeffcott rotor and would change along an axis over
/// `key`. The study stores frequency and damping ratio instead, but the user expects the constants to stay
/// the same. Empty where no constant would change.
std::string_view key_of_constants(const yaml::Node& root, std::string_view key) {
  const auto is_given = [&](std::string_view name) {
    return yaml::entry(*find_node(root, "rotor"), name) != nullptr;
  };
  const yaml::Node* kind = find_node(root, "rotor.kind");
  if (kind == nullptr || kind->text != "jeffcott") return "";
  const bool stiffness = is_given(machine::rotor_stiffness_key),
             damping = is_given(machine::rotor_damping_key);
  if (key == "rotor.mass_kg" && stiffness) return machine::rotor_stiffness_key;
  const bool changes_ratio =
      key == "rotor.mass_kg" || key == "rotor.natural_frequency_hz" || key == "rotor.stiffness_n_per_m";
  return changes_ratio && damping ? machine::rotor_damping_key : "";
}

/// Refuses an axis over a key that would change a given constant; true where it did.
bool refuse_constants(const yaml::Node& root, const std::string& key, const yaml::SourcePosition& place,
                      yaml::Diagnostics& diagnostics) {
  const std::string_view constant = key_of_constants(root, key);
  if (constant.empty()) return false;
  diagnostics.add(place, yaml::shown(key),
                  fmt::format("is varied beside rotor.{}, which it would change", constant),
                  "natural_frequency_hz and damping_ratio of a rotor whose mass or stiffness is varied");
  return true;
}

void refuse_impossible(const sweep::KeyAxis& axis, const yaml::SourcePosition& place, yaml::Node document,
                       std::string_view by_mass, yaml::Diagnostics& diagnostics) {
  for (const std::string& key : axis.keys) {
    if (!may_be_swept(document, key, by_mass, place, diagnostics)) return;
  }
  place_all(document, place);
  const std::size_t problems = diagnostics.count();
  for (const double value : axis.values) {
    read_varied(document, sweep::keys_at(axis, value), place, diagnostics);
    if (diagnostics.count() != problems) return;
  }
}

/// Refuses an axis of the sweep over a key that the study varies itself: the study would overwrite its
/// values.
void refuse_swept(const sweep::Study& study, const std::vector<std::string>& keys,
                  const yaml::SourcePosition& place, yaml::Diagnostics& diagnostics) {
  const std::vector<std::string> swept = sweep::key_names(study.grid);
  for (const std::string& key : keys) {
    if (std::ranges::find(swept, key) != swept.end())
      diagnostics.add(place, yaml::shown(key), "is varied by an axis of the sweep as well", "one of the two");
  }
}

yaml::SourcePosition place_of_keys(const yaml::Node& axis) {
  const yaml::Node* keys = find_node(axis, "key");
  if (keys == nullptr) keys = find_node(axis, "keys");
  return keys->place;
}

}  // namespace

void vary_keys(const yaml::Value& root, sweep::Study& study) {
  if (study.grid.axes.empty() && !study.threshold && !study.basin) return;
  yaml::Node document = document_of(study);
  const yaml::Node& sweep = *find_node(root.node, "sweep");
  const std::string_view by_mass = study::key_by_mass(sweep, study.machine);
  const auto refuse_axis = [&](const sweep::KeyAxis& axis, const yaml::SourcePosition& place) {
    for (const std::string& key : axis.keys) {
      if (refuse_constants(root.node, key, place, root.diagnostics)) return;
    }
    refuse_impossible(axis, place, document, by_mass, root.diagnostics);
  };
  std::size_t next = 0;
  for (const std::string_view name : study::key_axis_names) {
    const yaml::Node* node = find_node(sweep, name);
    if (node == nullptr) continue;
    refuse_axis(study.grid.axes.at(next++), place_of_keys(*node));
  }
  if (study.threshold) {
    const yaml::SourcePosition place = place_of_keys(*find_node(root.node, "study"));
    refuse_swept(study, study.threshold->axis.keys, place, root.diagnostics);
    refuse_axis(study.threshold->axis, place);
  }
  if (study.basin) {
    const yaml::Node& over = *find_node(root.node, "study.over");
    for (std::size_t i = 0; i < study.basin->over.size(); ++i) {
      const sweep::DrawnKey& drawn = study.basin->over[i];
      const yaml::SourcePosition place = place_of_keys(over.items.at(i));
      refuse_swept(study, {drawn.key}, place, root.diagnostics);
      refuse_axis({{drawn.key}, {1}, {drawn.from, drawn.to}}, place);
    }
  }
  study.with_keys = [document = std::make_shared<const yaml::Node>(std::move(document))](
                        std::span<const sweep::KeyValue> keys) {
    yaml::Diagnostics diagnostics("the study with the keys of a cell", {});
    sweep::Study varied = read_varied(*document, keys, yaml::SourcePosition{}, diagnostics);
    diagnostics.throw_if_any();
    return varied;
  };
}

}  // namespace rubsweep::config
