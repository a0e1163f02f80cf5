#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"

namespace rubsweep::config {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Scale that a number is compared with.
enum class Scale {
  one,
  frequency_hz,      ///< the lowest natural frequency
  frequency_rpm,     ///< lowest natural frequency in revolutions per minute
  period_s,          ///< period of the lowest natural frequency
  clearance,         ///< clearance of the stop
  clearance_g_mm,    ///< unbalance in g mm at which the eccentricity equals the clearance
  contact_radius,    ///< radius of the stop
  rotor_stiffness,   ///< stiffness of a Jeffcott rotor
  rotor_power,       ///< K in N/m^n of a law K p^n that is as stiff as the rotor at p = clearance / 20
  clearance_blow_n,  ///< force of the kick that moves a Jeffcott rotor by the clearance of the stop
  weight_per_mm      ///< stiffness in N/m at which the rotor's weight causes a deflection of 1 mm
};

/// A plausible number lies between `low` and `high` times its scale, both ends included unless another member
/// excludes them.
struct SlipRule {
  Quantity quantity;
  Scale scale;
  double low, high;
  bool high_open;
  double floor;           ///< absolute values up to this number are plausible
  bool certain;           ///< true: the number is refused; false: the user is only asked
  std::string_view what;  ///< format: {0} number, {1} number / scale, {2} exceeded end, {3} `high`
  std::string_view slip;  ///< the unit that was probably meant ...
  double factor;          ///< ... and its value in units of the key; 0: no unit explains the number
};

using enum Quantity;

constexpr std::array rules{
    SlipRule{speed_hz, Scale::frequency_hz, 0, 100, false, 0, true,
             "{0} Hz is over {3} times the lowest natural frequency", "revolutions per minute", 1. / 60},
    SlipRule{speed_hz, Scale::frequency_hz, 0, 20, false, 0, false,
             "{0} Hz is over {3} times the lowest natural frequency", "revolutions per minute", 1. / 60},
    SlipRule{speed_rpm, Scale::frequency_rpm, 0, 100, false, 0, true,
             "{0} revolutions per minute is over {3} times the lowest natural frequency", "", 0},
    SlipRule{speed_rpm, Scale::frequency_rpm, 0, 20, false, 0, false,
             "{0} revolutions per minute is over {3} times the lowest natural frequency", "", 0},
    SlipRule{whirl_ratio, Scale::one, 0, 10, false, 0, false, "{0} times the clearance is no quiet motion",
             "per cent", 0.01},
    SlipRule{eccentricity_m, Scale::clearance, 0, 10, false, 0, false, "{0} m is {1:.4g} clearances",
             "millimetres", 1e-3},
    SlipRule{unbalance_g_mm, Scale::clearance_g_mm, 0, 10, false, 0, false,
             "{0} g mm is an eccentricity of {1:.4g} clearances", "", 0},
    SlipRule{clearance_m, Scale::contact_radius, 0, 1, true, 0, true,
             "{0} m is no less than contact_radius_m", "millimetres", 1e-3},
    SlipRule{clearance_m, Scale::contact_radius, 0, 0.3, false, 0, false,
             "{0} m is {1:.4g} of contact_radius_m", "millimetres", 1e-3},
    SlipRule{clearance_m, Scale::one, 1e-6, infinite, false, 0, false, "{0} m is less than a micrometre",
             "millimetres", 1e3},
    SlipRule{contact_radius_m, Scale::one, 0, 10, false, 0, true, "{0} m is no radius of a shaft",
             "millimetres", 1e-3},
    SlipRule{contact_stiffness_n_per_m, Scale::rotor_stiffness, 0.1, infinite, false, 0, false,
             "{0} N/m is softer than a tenth of the rotor", "newtons per millimetre", 1e3},
    SlipRule{power_stiffness_n_per_m_n, Scale::rotor_power, 0.1, 1e7, false, 0, false,
             "{0} N/m^n is {1:.4g} times the stiffness of the rotor at a twentieth of the clearance",
             "newtons per millimetre to that exponent", 3.16e4},
    SlipRule{support_stiffness_n_per_m, Scale::weight_per_mm, 0.1, infinite, false, 0, false,
             "{0} N/m gives way by more than 10 mm under the weight of the rotor", "newtons per millimetre",
             1e3},
    SlipRule{damping_ratio, Scale::one, 0, 1, true, 0, true,
             "{0} of critical damping leaves the rotor no vibration", "per cent", 0.01},
    SlipRule{damping_ratio, Scale::one, 0, 0.4, false, 0, false,
             "{0} of critical damping is much for a rotor", "per cent", 0.01},
    SlipRule{friction_coefficient, Scale::one, 0, 1.5, false, 0, false,
             "{0} is more friction than surfaces have that slide on", "per cent", 0.01},
    SlipRule{kick_force_n, Scale::clearance_blow_n, 0, 200, false, 0, false,
             "{0} N would move the rotor by {1:.3g} clearances", "millinewtons", 1e-3},
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

/// Lowest natural frequency in Hz, for a kit at rest; empty where its structure cannot be computed.
std::optional<double> lowest_frequency_hz(const model::Machine& machine) {
  if (const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor))
    return rotor->natural_frequency_hz;
  try {
    const scene::PreparedMachine prepared = scene::prepare_with_modes(machine, 1);
    double lowest = infinite;
    for (const auto& plane : prepared.reduction->frequency_hz) {
      if (plane.size() > 0) lowest = std::min(lowest, plane.minCoeff());
    }
    if (lowest > 0 && std::isfinite(lowest)) return lowest;
  } catch (const ConfigError&) {  // reported by the simulation later
  }
  return std::nullopt;
}

/// Lower bound of a kit's lowest natural frequency, in Hz. Speeds that are plausible at this frequency are
/// accepted without the cost of computing the structure.
constexpr double slow_hz = 10;

/// Force in N of the half-sine pulse that moves an undamped Jeffcott rotor by the clearance: a short pulse by
/// its impulse, a long one quasi-statically. Empty without a kick or a Jeffcott rotor.
std::optional<double> clearance_blow_n(const model::Machine& machine, const model::Stop* stop) {
  const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor);
  if (rotor == nullptr || stop == nullptr || !machine.kick) return std::nullopt;
  const double w = 2 * std::numbers::pi * rotor->natural_frequency_hz;
  double shortest_s = infinite;
  model::for_each_kick(
      machine, [&](const model::Kick& kick, auto) { shortest_s = std::min(shortest_s, kick.duration_s); });
  const double short_blow = 2 / std::numbers::pi * w * shortest_s, long_push = 2;
  return stop->clearance_m * rotor->mass_kg * w * w / std::min(short_blow, long_push);
}

/// Stiffness of a Jeffcott rotor; for a kit, the stiffness at which its weight causes a deflection of 1 mm.
double rotor_stiffness_n_per_m(const model::Machine& machine) {
  if (const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor))
    return rotor->mass_kg * std::pow(2 * std::numbers::pi * rotor->natural_frequency_hz, 2);
  return model::rotor_mass_kg(machine) * 9.81 / 1e-3;
}

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
    case Scale::one: break;
    case Scale::frequency_hz: scale = frequency_hz(value > rule.high * slow_hz); break;
    case Scale::frequency_rpm:
      scale = frequency_hz(value > rule.high * slow_hz * model::rpm_per_hz);
      if (scale) scale = *scale * model::rpm_per_hz;
      break;
    case Scale::period_s:
      // Kicks up to the floor were accepted above, so the frequency is computed here in any case.
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
      if (model::kit_of(*machine) == nullptr) scale = rotor_stiffness_n_per_m(*machine);
      break;
    case Scale::rotor_power:
      if (at != nullptr)
        scale = rotor_stiffness_n_per_m(*machine) / std::pow(at->clearance_m / 20, at->law.exponent - 1);
      break;
    case Scale::clearance_blow_n: scale = clearance_blow_n(*machine, at); break;
    case Scale::weight_per_mm: scale = model::rotor_mass_kg(*machine) * 9.81 / 1e-3; break;
  }
  return scale && *scale > 0 && std::isfinite(*scale) ? scale : std::nullopt;
}

bool plausible(const SlipRule& rule, double ratio) {
  return ratio >= rule.low && (rule.high_open ? ratio < rule.high : ratio <= rule.high);
}

/// Asks about an angle in degrees that is a simple fraction of pi, such as 1.57 or 3.14: probably radians.
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
  // A stiffness of 0 means no support; 0 is also plausible for all other quantities.
  if (value == 0 || (rule.floor > 0 && std::abs(value) <= rule.floor)) return std::nullopt;
  const auto scale = scale_of(rule, value, machine, stop);
  if (!scale) return std::nullopt;
  const double ratio = value / *scale;
  // Compares the value itself with the upper end, as the message shows both. A quotient could differ from
  // them by rounding.
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

}  // namespace

std::optional<Slip> slip_of(Quantity quantity, double value, const model::Machine* machine,
                            std::size_t stop) {
  if (quantity == angle_deg) return radians(value);
  if (quantity == support_stiffness_n_per_m && value < 0)
    return std::nullopt;  // seal, which carries no weight
  for (const SlipRule& rule : rules) {
    if (rule.quantity != quantity) continue;
    if (auto slip = slip_by(rule, value, machine, stop)) return slip;
  }
  return std::nullopt;
}

}  // namespace rubsweep::config
