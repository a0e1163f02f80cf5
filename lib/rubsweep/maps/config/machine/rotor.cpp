#include "rubsweep/maps/config/machine/rotor.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view frequency_key = "natural_frequency_hz", ratio_key = "damping_ratio";

bool is_given(yaml::Section& section, std::string_view key) { return section.find(key).has_value(); }

/// Reads a number of the struct by its own key, or by the key of another number from which it is computed. If
/// both are given, that is a problem.
void read_one(yaml::Section& section, std::string_view own_key, double& own, std::string_view other_key,
              std::optional<double>& other, const model::Range& range) {
  const bool own_given = is_given(section, own_key), other_given = is_given(section, other_key);
  if (!other_given) return section.field(own_key, own, range);
  if (own_given) section.require_exactly_one({own_key, other_key});
  section.field(other_key, other, range);
}

/// Kinds in the order of model::Rotor, then kinds for files of other tools, which are converted to one of the
/// first two kinds.
constexpr std::array<std::string_view, 4> rotor_kinds{"jeffcott", "rotor_kit", "ross", "matrices"};

/// Keys of `rotor` for kind: jeffcott, except `kind`.
model::JeffcottRotor read_jeffcott(yaml::Section& section) {
  model::JeffcottRotor rotor;
  std::optional<double> stiffness, damping;
  model::JeffcottRotor::visit_fields(
      rotor, [&](std::string_view name, double& field, const model::Range& range) {
        if (name == frequency_key) {
          read_one(section, name, field, rotor_stiffness_key, stiffness, range);
        } else if (name == ratio_key) {
          read_one(section, name, field, rotor_damping_key, damping, range);
        } else {
          section.field(name, field, range);
        }
      });
  if (!section.is_sound()) return rotor;
  if (stiffness) rotor.natural_frequency_hz = std::sqrt(*stiffness / rotor.mass_kg) / (2 * std::numbers::pi);
  if (damping)
    rotor.damping_ratio = *damping / (4 * std::numbers::pi * rotor.mass_kg * rotor.natural_frequency_hz);
  model::JeffcottRotor::visit_fields(
      rotor, [&](std::string_view name, double field, const model::Range& range) {
        if (model::contains(range, field)) return;
        const std::string_view given = name == ratio_key ? rotor_damping_key : rotor_stiffness_key;
        section.refuse_together(given, {given, "mass_kg"}, "gives a rotor beyond all numbers",
                                "stiffness, damping and mass that belong together");
      });
  return rotor;
}

}  // namespace

void read_rotor(const yaml::Value& value, model::Machine& machine) {
  yaml::Section section(value);
  const auto kind = section.require_kind("kind", rotor_kinds);
  if (kind && rotor_kinds[*kind] == "rotor_kit") {
    machine.rotor = read_rotor_kit(section);
  } else if (kind && rotor_kinds[*kind] == "ross") {
    machine.rotor = read_ross_rotor(section);
  } else if (kind && rotor_kinds[*kind] == "matrices") {
    machine.rotor = read_matrix_rotor(section);
  } else {
    machine.rotor = read_jeffcott(section);
  }
}

keys::Form rotor_form() {
  using namespace keys;
  const auto of_kind = [](std::string_view kind, std::vector<Key> keys, std::vector<Choice> choices = {}) {
    return map_of(
        joined({{must("kind", one_of({&kind, 1}),
                      "kind of rotor: one disc on a massless shaft (jeffcott), a shaft line, a file of "
                      "ROSS, or matrices")},
                std::move(keys)}),
        std::move(choices));
  };
  std::vector<Key> constants = newer(
      {must(std::string(rotor_stiffness_key), number(model::positive), "stiffness of the shaft at the disc"),
       must(std::string(rotor_damping_key), number(model::not_negative), "damping constant of the disc")});
  return any_of({of_kind("jeffcott", joined({keys_of<model::JeffcottRotor>(), std::move(constants)}),
                         {either(std::array{frequency_key, rotor_stiffness_key}),
                          either(std::array{ratio_key, rotor_damping_key})}),
                 of_kind("rotor_kit", rotor_kit_keys()), of_kind("ross", ross_keys()),
                 of_kind("matrices", matrix_rotor_keys())});
}

void print_rotor(yaml::Printer& printer, const model::Machine& machine, MatrixPrint matrices) {
  const model::RotorKit* by_matrices = model::kit_of(machine);
  printer.open("rotor");
  printer.word("kind", by_matrices != nullptr && by_matrices->matrices ? "matrices"
                                                                       : rotor_kinds[machine.rotor.index()]);
  std::visit(overloaded{[&](const model::JeffcottRotor& rotor) { print_fields(printer, rotor); },
                        [&](const model::RotorKit& kit) { print_rotor_kit(printer, kit, matrices); }},
             machine.rotor);
  printer.close();
}

}  // namespace rubsweep::config::machine
