#include "rubsweep/maps/config/unit_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config {
namespace {

using enum Quantity;

/// Path of a number and its quantity. `*` is any index of a list, `kick` any kick. An axis stands for all its
/// values.
struct Standing {
  std::string_view pattern;
  Quantity quantity;
};
constexpr std::array standings{
    Standing{"rotor.damping_ratio", damping_ratio},
    Standing{"rotor.rotating_damping_ratio", damping_ratio},
    Standing{"rotor.shaft.*.length_m", length_m},
    Standing{"rotor.shaft.*.outer_diameter_m", diameter_m},
    Standing{"rotor.shaft.*.youngs_modulus_pa", modulus_pa},
    Standing{"rotor.shaft.*.shear_modulus_pa", modulus_pa},
    Standing{"rotor.shaft.*.density_kg_per_m3", density_kg_per_m3},
    Standing{"rotor.supports.*.stiffness_x_n_per_m", support_stiffness_n_per_m},
    Standing{"rotor.supports.*.stiffness_y_n_per_m", support_stiffness_n_per_m},
    Standing{"rotor.sensors.*.angle_deg", angle_deg},
    Standing{"stops.*.clearance_m", clearance_m},
    Standing{"stops.*.contact_radius_m", contact_radius_m},
    Standing{"stops.*.stiffness_n_per_m", contact_stiffness_n_per_m},
    Standing{"stops.*.law.stiffness_n_per_m_n", power_stiffness_n_per_m_n},
    Standing{"stops.*.angle_deg", angle_deg},
    Standing{"stops.*.hertz.rotor.youngs_modulus_pa", modulus_pa},
    Standing{"stops.*.hertz.casing.youngs_modulus_pa", modulus_pa},
    Standing{"stops.*.friction.coefficient", friction_coefficient},
    Standing{"stops.*.friction.one_way", friction_coefficient},
    Standing{"stops.*.friction.static", friction_coefficient},
    Standing{"stops.*.friction.kinetic", friction_coefficient},
    Standing{"kick.force_n", kick_force_n},
    Standing{"kick.duration_s", kick_duration_s},
    Standing{"kick.angle_deg", angle_deg},
    Standing{"kick.phase_deg", angle_deg},
    Standing{"start.x_m", displacement_m},
    Standing{"start.y_m", displacement_m},
    Standing{"gravity_m_per_s2", gravity_m_per_s2},
    Standing{"sweep.speed_hz", speed_hz},
    Standing{"sweep.speed_rpm", speed_rpm},
    Standing{"sweep.whirl_ratio", whirl_ratio},
    Standing{"sweep.eccentricity_m", eccentricity_m},
    Standing{"sweep.unbalance_g_mm", unbalance_g_mm},
    Standing{"ring.geometry.radius_m", length_m},
    Standing{"ring.geometry.thickness_m", diameter_m},
    Standing{"ring.geometry.youngs_modulus_pa", modulus_pa},
    Standing{"ring.geometry.density_kg_per_m3", density_kg_per_m3},
    Standing{"loads.*.angle_deg", angle_deg},
    Standing{"loads.*.inclination_deg", angle_deg},
    Standing{"loads.*.geometry.youngs_modulus_pa", modulus_pa},
    Standing{"loads.*.geometry.density_kg_per_m3", density_kg_per_m3},
};

/// A number in the configuration, and the question about it.
struct Found {
  yaml::Value value;
  Slip slip;
};

class Search {
 public:
  Search(const model::Machine* machine, bool certain) : machine_(machine), certain_(certain) {}

  /// Follows the rest of a pattern from `value`. `index` is the last index of a list on the path, that is,
  /// the index of the stop.
  void walk(const yaml::Value& value, std::string_view pattern, Quantity quantity, std::size_t index = 0) {
    if (pattern.empty()) {
      judge_axis(value, quantity, index);
      return;
    }
    const std::size_t dot = pattern.find('.');
    const std::string_view name = pattern.substr(0, dot);
    const std::string_view rest = dot == std::string_view::npos ? "" : pattern.substr(dot + 1);
    for (std::size_t i = 0; i < value.node.items.size(); ++i) {
      const bool list = value.node.kind == yaml::Node::Kind::list;
      const std::string key = list ? std::to_string(i) : value.node.keys[i].text;
      if (list != (name == "*") || (!list && key != name && !(name == "kick" && model::is_of_kick(key))))
        continue;
      walk(value.at(i), rest, quantity, list ? i : index);
    }
  }

  std::vector<Found> take() { return std::move(found_); }

 private:
  /// Judges a single number, or both ends or all values of an axis.
  void judge_axis(const yaml::Value& value, Quantity quantity, std::size_t index) {
    judge(value, quantity, index);
    for (const std::string_view end : {"from", "to"}) walk_to(value, end, quantity, index);
    walk_to(value, "values", quantity, index);
    if (value.node.kind != yaml::Node::Kind::list) return;
    for (std::size_t i = 0; i < value.node.items.size(); ++i) judge(value.at(i), quantity, index);
  }

  void walk_to(const yaml::Value& value, std::string_view name, Quantity quantity, std::size_t index) {
    if (value.node.kind == yaml::Node::Kind::map) walk(value, name, quantity, index);
  }

  void judge(const yaml::Value& value, Quantity quantity, std::size_t index) {
    const auto number = yaml::number_of(value.node);
    if (!number) return;
    if (auto slip = slip_of(quantity, *number, machine_, index); slip && slip->certain == certain_)
      found_.push_back({value, *std::move(slip)});
  }

  const model::Machine* machine_;
  bool certain_;
  std::vector<Found> found_;
};

std::vector<Found> search(const yaml::Value& root, const model::Machine* machine, bool certain) {
  Search found(machine, certain);
  for (const Standing& standing : standings) found.walk(root, standing.pattern, standing.quantity);
  return found.take();
}

double largest_of(const yaml::Node* axis) {
  double largest = -std::numeric_limits<double>::infinity();
  const auto add = [&](const yaml::Node& node) {
    largest = std::max(largest, yaml::number_of(node).value_or(largest));
  };
  if (axis == nullptr) return largest;
  add(*axis);
  for (const std::string_view end : {"from", "to"}) {
    if (const yaml::Node* node = find_node(*axis, end)) add(*node);
  }
  if (const yaml::Node* values = find_node(*axis, "values")) std::ranges::for_each(values->items, add);
  return largest;
}

/// Question where speeds look like whirl ratios and whirl ratios like speeds.
std::optional<std::string> swapped_axes(const yaml::Value& root) {
  const yaml::Node* speeds = find_node(root.node, "sweep.speed_hz");
  const yaml::Node* ratios = find_node(root.node, "sweep.whirl_ratio");
  const double fastest = largest_of(speeds), largest = largest_of(ratios);
  if (!(fastest > 0 && fastest <= 1.5 && largest > 10)) return std::nullopt;
  return fmt::format("{}: sweep: speeds up to {} and whirl ratios up to {} (the two axes swapped?)",
                     root.diagnostics.describe(speeds->place), model::speed_text(fastest), largest);
}

}  // namespace

void refuse_unit_slips(const yaml::Value& root, const model::Machine* machine) {
  for (const Found& found : search(root, machine, true))
    refuse(found.value, found.slip.wrong, found.slip.allowed);
}

std::vector<std::string> unit_questions(const yaml::Value& root, const model::Machine* machine) {
  std::vector<std::string> questions;
  if (auto swapped = swapped_axes(root)) return {*std::move(swapped)};
  std::string last_key;
  for (const Found& found : search(root, machine, false)) {
    // Key of the axis, without `from`, `to` or the index of a value.
    const std::string path = found.value.path;
    const std::string key = path.starts_with("sweep.") ? path.substr(0, path.find('.', 6)) : path;
    if (key == last_key) continue;
    last_key = key;
    questions.push_back(fmt::format("{}: {}: {}", found.value.diagnostics.describe(found.value.node.place),
                                    path, found.slip.wrong));
  }
  return questions;
}

}  // namespace rubsweep::config
