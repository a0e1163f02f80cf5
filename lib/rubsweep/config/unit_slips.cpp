#include "rubsweep/config/unit_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "rubsweep/config/number.hpp"
#include "rubsweep/config/override.hpp"
#include "rubsweep/config/place_axes.hpp"
#include "rubsweep/config/text.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/model/balance.hpp"
#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::config {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Scale that a number is compared with.
enum class Scale {
  one,
  frequency_hz,     ///< the lowest natural frequency
  frequency_rpm,    ///< the same in revolutions per minute
  period_s,         ///< of that frequency
  clearance,        ///< of the stop
  clearance_g_mm,   ///< unbalance whose eccentricity is that clearance
  contact_radius,   ///< of the stop
  rotor_stiffness,  ///< of a Jeffcott rotor
  weight_per_mm     ///< stiffness that gives way by one millimetre under the rotor's weight
};

/// A plausible number lies between `low` and `high` times its scale, both included unless said otherwise.
struct SlipRule {
  Quantity quantity;
  Scale scale;
  double low, high;
  bool high_open;
  double floor;           ///< numbers up to here are never judged
  bool certain;           ///< refused; else asked about
  std::string_view what;  ///< {0}: the number, {1}: the number by its scale, {2}: the end that it is beyond
  std::string_view slip;  ///< the unit that was probably meant ...
  double factor;          ///< ... and by what it turns into that of the key; 0: no unit explains it
};

using enum Quantity;

constexpr std::array rules{
    SlipRule{speed_hz, Scale::frequency_hz, 0, 100, false, 0, true,
             "{0} Hz is over {3} times the lowest natural frequency", "revolutions per minute", 1. / 60},
    SlipRule{speed_rpm, Scale::frequency_rpm, 0, 100, false, 0, true,
             "{0} revolutions per minute is over {3} times the lowest natural frequency", "", 0},
    SlipRule{whirl_ratio, Scale::one, 0, 10, false, 0, false, "{0} times the clearance is no quiet motion",
             "per cent", 0.01},
    SlipRule{eccentricity_m, Scale::clearance, 0, 10, false, 0, false, "{0} m is {1:.4g} clearances",
             "millimetres", 1e-3},
    SlipRule{unbalance_g_mm, Scale::clearance_g_mm, 0, 10, false, 0, false,
             "{0} g mm is an eccentricity of {1:.4g} clearances", "", 0},
    SlipRule{clearance_m, Scale::contact_radius, 0, 1, true, 0, true,
             "{0} m is no less than contact_radius_m", "millimetres", 1e-3},
    SlipRule{contact_radius_m, Scale::one, 0, 10, false, 0, true, "{0} m is no radius of a shaft",
             "millimetres", 1e-3},
    SlipRule{contact_stiffness_n_per_m, Scale::rotor_stiffness, 0.1, infinite, false, 0, false,
             "{0} N/m is softer than a tenth of the rotor", "newtons per millimetre", 1e3},
    SlipRule{support_stiffness_n_per_m, Scale::weight_per_mm, 0.1, infinite, false, 0, false,
             "{0} N/m gives way by more than 10 mm under the weight of the rotor", "newtons per millimetre",
             1e3},
    SlipRule{damping_ratio, Scale::one, 0, 1, true, 0, true,
             "{0} of critical damping leaves the rotor no vibration", "per cent", 0.01},
    SlipRule{kick_duration_s, Scale::period_s, 0, 100, false, 0, true,
             "{1:.4g} periods of the rotor are no kick", "milliseconds", 1e-3},
    SlipRule{kick_duration_s, Scale::period_s, 0, 20, false, 0.1, false,
             "{0} s is {1:.4g} periods of the rotor, long for a kick", "milliseconds", 1e-3},
    SlipRule{gravity_m_per_s2, Scale::one, 0, 100, false, 0, true, "{0} m/s2 is no gravity", "millimetres",
             1e-3},
    SlipRule{displacement_m, Scale::clearance, -10, 10, false, 0, false, "{0} m is {1:.4g} clearances",
             "millimetres", 1e-3},
    SlipRule{diameter_m, Scale::one, 0, 20, false, 0, true, "{0} m is no diameter of a shaft", "millimetres",
             1e-3},
    SlipRule{length_m, Scale::one, 0, 100, true, 0, false, "{0} m is long", "millimetres", 1e-3},
    SlipRule{modulus_pa, Scale::one, 1e5, infinite, false, 0, true, "{0} Pa is softer than any solid",
             "gigapascals", 1e9},
    SlipRule{modulus_pa, Scale::one, 1e7, infinite, false, 0, false, "{0} Pa is softer than rubber",
             "newtons per square millimetre", 1e6},
    SlipRule{density_kg_per_m3, Scale::one, 100, infinite, false, 0, false, "{0} kg/m3 is lighter than cork",
             "grams per cubic centimetre", 1e3},
};

/// Position of the numbers of a quantity; `*` is any index of a list, or any key of a map of casings. For an
/// axis all its values.
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
    Standing{"stops.*.angle_deg", angle_deg},
    Standing{"stops.*.hertz.rotor.youngs_modulus_pa", modulus_pa},
    Standing{"stops.*.hertz.casing.youngs_modulus_pa", modulus_pa},
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

/// Lowest natural frequency, of a kit at rest; empty where no structure can be computed.
std::optional<double> lowest_frequency_hz(const model::Machine& machine) {
  if (const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor))
    return rotor->natural_frequency_hz;
  try {
    const scene::PreparedMachine prepared = scene::prepare_machine(machine);
    double lowest = infinite;
    for (const auto& plane : prepared.reduction->frequency_hz) {
      if (plane.size() > 0) lowest = std::min(lowest, plane.minCoeff());
    }
    if (lowest > 0 && std::isfinite(lowest)) return lowest;
  } catch (const ConfigError&) {  // said by whoever simulates it
  }
  return std::nullopt;
}

/// A bound that costs nothing: shafts rarely vibrate slower than this, so that slower speeds and shorter
/// kicks of a kit are never judged, and its structure need not be computed.
constexpr double slow_hz = 10;

std::optional<double> scale_of(const SlipRule& rule, double value, const model::Machine* machine,
                               std::size_t stop) {
  if (rule.scale == Scale::one) return 1;
  if (machine == nullptr) return std::nullopt;
  const model::Stop* at = stop < machine->stops.size() ? &machine->stops[stop] : nullptr;
  const auto frequency_hz = [&](bool may_be_beyond) {
    const bool kit = model::kit_of(*machine) != nullptr;
    return kit && !may_be_beyond ? std::nullopt : lowest_frequency_hz(*machine);
  };
  std::optional<double> scale;
  switch (rule.scale) {
    case Scale::one:
      break;
    case Scale::frequency_hz:
      scale = frequency_hz(value > rule.high * slow_hz);
      break;
    case Scale::frequency_rpm:
      scale = frequency_hz(value > rule.high * slow_hz * rpm_per_hz);
      if (scale) scale = *scale * rpm_per_hz;
      break;
    case Scale::period_s:
      // Ten times faster than that is no slow shaft any more.
      scale = frequency_hz(value > rule.floor);
      if (scale) scale = 1 / *scale;
      break;
    case Scale::clearance:
      if (at != nullptr) scale = at->clearance_m;
      break;
    case Scale::clearance_g_mm:
      if (at != nullptr) scale = at->clearance_m * model::g_mm_per_metre(*machine);
      break;
    case Scale::contact_radius:
      if (at != nullptr && at->contact_radius_m > 0) scale = at->contact_radius_m;
      break;
    case Scale::rotor_stiffness:
      if (const auto* rotor = std::get_if<model::JeffcottRotor>(&machine->rotor))
        scale = rotor->mass_kg * std::pow(2 * std::numbers::pi * rotor->natural_frequency_hz, 2);
      break;
    case Scale::weight_per_mm:
      scale = model::rotor_mass_kg(*machine) * 9.81 / 1e-3;
      break;
  }
  return scale && *scale > 0 && std::isfinite(*scale) ? scale : std::nullopt;
}

bool plausible(const SlipRule& rule, double ratio) {
  return ratio >= rule.low && (rule.high_open ? ratio < rule.high : ratio <= rule.high);
}

/// A wall or a kick that is given in degrees seldom stands at 1.57 or 3.14 of them.
std::optional<Slip> radians(double value) {
  constexpr double close = 2e-3;
  constexpr std::array parts{1. / 6, 1. / 4, 1. / 3, 1. / 2, 2. / 3, 3. / 4, 1., 3. / 2, 2.};
  for (const double part : parts) {
    const double angle = part * std::numbers::pi;
    if (std::abs(std::abs(value) - angle) > close * angle) continue;
    return Slip{fmt::format("{} degrees is {:.4g} pi (radians?)", value, value / std::numbers::pi),
                fmt::format("{:.4g} for that angle", value * 180 / std::numbers::pi)};
  }
  return std::nullopt;
}

std::optional<Slip> slip_by(const SlipRule& rule, double value, const model::Machine* machine,
                            std::size_t stop) {
  // 0 stiffness of a support is none at all, and no other quantity is too small at 0.
  if (value == 0 || (rule.floor > 0 && std::abs(value) <= rule.floor)) return std::nullopt;
  const auto scale = scale_of(rule, value, machine, stop);
  if (!scale) return std::nullopt;
  const double ratio = value / *scale;
  // An end is compared as it is shown, not as division leaves it.
  const bool beyond =
      ratio < rule.low || value > rule.high * *scale || (rule.high_open && value >= rule.high * *scale);
  if (!beyond) return std::nullopt;
  const bool too_large = ratio > rule.low && std::isfinite(rule.high);
  const double end = (too_large ? rule.high : rule.low) * *scale;
  std::string wrong = fmt::format(fmt::runtime(rule.what), value, ratio, end, rule.high);
  if (rule.factor != 0 && plausible(rule, ratio * rule.factor)) wrong += fmt::format(" ({}?)", rule.slip);
  return Slip{std::move(wrong),
              fmt::format("{} {}", too_large ? (rule.high_open ? "less than" : "at most") : "at least", end),
              rule.certain};
}

/// A number in the configuration, and the question about it.
struct Found {
  Value value;
  Slip slip;
};

class Search {
 public:
  Search(const model::Machine* machine, bool certain) : machine_(machine), certain_(certain) {}

  /// Walks down the rest of a pattern; `index` is that of the first list that was met.
  void walk(const Value& value, std::string_view pattern, Quantity quantity, std::size_t index = 0) {
    if (pattern.empty()) {
      judge_axis(value, quantity, index);
      return;
    }
    const std::size_t dot = pattern.find('.');
    const std::string_view name = pattern.substr(0, dot);
    const std::string_view rest = dot == std::string_view::npos ? "" : pattern.substr(dot + 1);
    for (std::size_t i = 0; i < value.node.items.size(); ++i) {
      const bool list = value.node.kind == Node::Kind::list;
      if (list != (name == "*") || (!list && value.node.keys[i].text != name)) continue;
      const std::string key = list ? std::to_string(i) : value.node.keys[i].text;
      walk({value.node.items[i], child_path(value.path, key), value.diagnostics}, rest, quantity,
           list ? i : index);
    }
  }

  std::vector<Found> take() { return std::move(found_); }

 private:
  /// A single number, both ends, or a list.
  void judge_axis(const Value& value, Quantity quantity, std::size_t index) {
    judge(value, quantity, index);
    for (const std::string_view end : {"from", "to"}) walk_to(value, end, quantity, index);
    walk_to(value, "values", quantity, index);
    if (value.node.kind != Node::Kind::list) return;
    for (std::size_t i = 0; i < value.node.items.size(); ++i) {
      judge({value.node.items[i], fmt::format("{}.{}", value.path, i), value.diagnostics}, quantity, index);
    }
  }

  void walk_to(const Value& value, std::string_view name, Quantity quantity, std::size_t index) {
    if (value.node.kind == Node::Kind::map) walk(value, name, quantity, index);
  }

  void judge(const Value& value, Quantity quantity, std::size_t index) {
    if (value.node.kind != Node::Kind::scalar) return;
    const ParsedNumber parsed = parse_number(value.node.text);
    if (parsed.error != NumberError::none) return;
    if (auto slip = slip_of(quantity, parsed.value, machine_, index); slip && slip->certain == certain_)
      found_.push_back({value, *std::move(slip)});
  }

  const model::Machine* machine_;
  bool certain_;
  std::vector<Found> found_;
};

std::vector<Found> search(const Value& root, const model::Machine* machine, bool certain) {
  Search found(machine, certain);
  for (const Standing& standing : standings) found.walk(root, standing.pattern, standing.quantity);
  return found.take();
}

double largest_of(const Node* axis) {
  double largest = -infinite;
  const auto add = [&](const Node& node) {
    const ParsedNumber number = parse_number(node.text);
    if (node.kind == Node::Kind::scalar && number.error == NumberError::none)
      largest = std::max(largest, number.value);
  };
  if (axis == nullptr) return largest;
  add(*axis);
  for (const std::string_view end : {"from", "to"}) {
    if (const Node* node = find_node(*axis, end)) add(*node);
  }
  if (const Node* values = find_node(*axis, "values")) std::ranges::for_each(values->items, add);
  return largest;
}

/// Speeds where whirl ratios should be and the other way round.
std::optional<std::string> swapped_axes(const Value& root) {
  const Node* speeds = find_node(root.node, "sweep.speed_hz");
  const Node* ratios = find_node(root.node, "sweep.whirl_ratio");
  const double fastest = largest_of(speeds), largest = largest_of(ratios);
  if (!(fastest > 0 && fastest <= 1.5 && largest > 10)) return std::nullopt;
  return fmt::format("{}: sweep: speeds up to {} Hz and whirl ratios up to {} (the two axes swapped?)",
                     root.diagnostics.describe(speeds->place), fastest, largest);
}

}  // namespace

std::optional<Slip> slip_of(Quantity quantity, double value, const model::Machine* machine,
                            std::size_t stop) {
  if (quantity == angle_deg) return radians(value);
  for (const SlipRule& rule : rules) {
    if (rule.quantity != quantity) continue;
    if (auto slip = slip_by(rule, value, machine, stop)) return slip;
  }
  return std::nullopt;
}

void refuse_unit_slips(const Value& root, const model::Machine* machine) {
  for (const Found& found : search(root, machine, true))
    refuse(found.value, found.slip.wrong, found.slip.allowed);
}

std::vector<std::string> unit_questions(const Value& root, const model::Machine* machine) {
  std::vector<std::string> questions;
  if (auto swapped = swapped_axes(root)) return {*std::move(swapped)};
  std::string last_key;
  for (const Found& found : search(root, machine, false)) {
    // The key of an axis, without its ends and the places of its values.
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
