#include "fuzz/random_config.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"

namespace rubsweep::fuzz {
namespace {

std::string jeffcott(ByteSource& b) {
  return fmt::format("rotor: {{kind: jeffcott, mass_kg: {}, natural_frequency_hz: {}, damping_ratio: {}}}\n",
                     b.number(0.8), b.number(30), b.number(0.02));
}

std::string segment(ByteSource& b) {
  std::string text = fmt::format(
      "    - {{length_m: {}, outer_diameter_m: {}, youngs_modulus_pa: {}, shear_modulus_pa: {}, "
      "density_kg_per_m3: {}",
      b.number(0.23), b.number(0.01), b.number(2.06e11), b.number(7.9e10), b.number(7850));
  if (b.once_in(4)) text += fmt::format(", inner_diameter_m: {}", b.number(0.004));
  return text + "}\n";
}

std::string disc(ByteSource& b) {
  std::string text =
      fmt::format("    - {{position_m: {}, mass_kg: {}, polar_inertia_kg_m2: {}, diametral_inertia_kg_m2: {}",
                  b.number(0.2), b.number(0.8), b.number(5.6e-4), b.number(5.6e-4));
  if (b.once_in(3)) {
    text += fmt::format(
        ", eccentricity_ratio: {}, eccentricity_phase_deg: {}, skew_rad_per_m: {}, skew_phase_deg: {}",
        b.number(0.5), b.number(30), b.number(2), b.number(20));
  }
  return text + "}\n";
}

std::string support(ByteSource& b, double place_m) {
  std::string text = fmt::format("    - {{position_m: {}, stiffness_x_n_per_m: {}, stiffness_y_n_per_m: {}",
                                 b.number(place_m), b.number(3.2e4), b.number(3.2e4));
  text += fmt::format(", damping_x_ns_per_m: {}, damping_y_ns_per_m: {}", b.number(5), b.number(5));
  if (b.once_in(4)) {
    text += fmt::format(", stiffness_xy_n_per_m: {}, stiffness_yx_n_per_m: {}, damping_xy_ns_per_m: {}",
                        b.number(100), b.number(-90), b.number(0.1));
  }
  if (b.once_in(4)) text += fmt::format(", angular_stiffness_nm_per_rad: {}", b.number(7));
  if (b.once_in(4)) {
    text += fmt::format(", pedestal: {{mass_kg: {}, stiffness_x_n_per_m: {}, stiffness_y_n_per_m: {}}}",
                        b.number(2), b.number(1e5), b.number(1.1e5));
  }
  if (b.once_in(6)) {
    text += fmt::format(", fault: {{impulse_ns: {}, multiple: {}, phase_deg: {}}}", b.number(0.01),
                        b.number(3), b.number(30));
  }
  return text + "}\n";
}

std::string bow(ByteSource& b) {
  if (b.once_in(2))
    return fmt::format("  bow: {{mode: {}, amplitude_m: {}}}\n", 1 + b.below(40), b.number(1e-5));
  return fmt::format("  bow: {{position_m: [0, {}, 0.4], deflection_m: [0, {}, 0]}}\n", b.number(0.2),
                     b.number(1e-5));
}

std::string kit(ByteSource& b) {
  std::string text = "rotor:\n  kind: rotor_kit\n  shaft:\n";
  const int segments = 2 + b.below(2), discs = b.below(3), couplings = b.once_in(4) ? 1 : 0;
  for (int i = 0; i < segments; ++i) text += segment(b);
  if (discs > 0) text += "  discs:\n";
  for (int i = 0; i < discs; ++i) text += disc(b);
  text += "  supports:\n" + support(b, 0.03) + support(b, 0.43);
  if (couplings > 0) {
    text += fmt::format(
        "  couplings:\n    - {{position_m: {}, lateral_stiffness_n_per_m: {}, angular_stiffness_nm_per_rad: "
        "{}}}\n",
        b.number(0.25), b.number(1e7), b.number(1e3));
  }
  if (b.once_in(2))
    text += fmt::format("  sensors:\n    - {{position_m: {}, angle_deg: 0}}\n", b.number(0.19));
  if (b.once_in(4)) text += bow(b);
  if (b.once_in(5)) text += fmt::format("  torsion: {{drive_stiffness_nm_per_rad: {}}}\n", b.number(20));
  text += fmt::format("  damping_ratio: [{}, 0.01]\n", b.number(0.02));
  if (b.once_in(2)) text += fmt::format("  modes: {}\n", 1 + b.below(4));
  text += fmt::format("  modes_up_to_hz: {}\n  elements: {}\n", b.number(600), 1 + b.below(16));
  return text;
}

std::string contact_stiffness(ByteSource& b) {
  if (!b.once_in(6)) return fmt::format("    stiffness_n_per_m: {}\n", b.number(2e6));
  return fmt::format(
      "    hertz: {{length_m: {}, design_force_n: {}, rotor: {{radius_m: {}, youngs_modulus_pa: {}, "
      "poisson_ratio: 0.3}}, "
      "casing: {{shape: flat, youngs_modulus_pa: {}, poisson_ratio: 0.34}}}}\n",
      b.number(0.006), b.number(250), b.number(0.005), b.number(2e11), b.number(1e11));
}

std::string friction(ByteSource& b) {
  switch (b.below(5)) {
    case 0: return "none";
    case 1: return fmt::format("{{coefficient: {}}}", b.number(0.1));
    case 2:
      return fmt::format("{{static: {}, kinetic: {}, peak_speed_m_per_s: {}, settle_speed_m_per_s: {}}}",
                         b.number(0.2), b.number(0.1), b.number(0.01), b.number(0.1));
    case 3:
      // Most curves with six random numbers can feed energy in, which is refused.
      return fmt::format("{{stribeck: [{}, {}, {}, {}, {}, {}]}}", b.number(0), b.number(0), b.number(0),
                         b.number(0.1), b.number(100), b.number(0));
    default: return fmt::format("{{stribeck: [0, 0, 0, {}, {}, 0]}}", b.number(0.1), b.number(100));
  }
}

std::string stop(ByteSource& b, bool on_shaft, int index) {
  std::string text = "  - kind: ";
  if (b.once_in(3)) {
    text += fmt::format("annular\n    offset_m: [{}, {}]\n", b.number(0), b.number(0));
  } else {
    text += fmt::format("one_side\n    angle_deg: {}\n", b.number(90 + 180 * index));
  }
  if (on_shaft) text += fmt::format("    position_m: {}\n", b.number(0.29));
  text += fmt::format("    clearance_m: {}\n", b.number(1e-3)) + contact_stiffness(b);
  switch (b.below(4)) {
    case 0: text += fmt::format("    restitution: {}\n", b.number(0.7)); break;
    case 1: text += fmt::format("    restitution_delivered: {}\n", b.number(0.7)); break;
    case 2: text += fmt::format("    restitution_by_rotor_mass: {}\n", b.number(0.7)); break;
    default: text += fmt::format("    damping_ns_per_m: {}\n", b.number(50));
  }
  text += fmt::format("    contact_radius_m: {}\n    friction: {}\n", b.number(0.0375), friction(b));
  if (b.once_in(6)) text += fmt::format("    contact_mass_kg: {}\n", b.number(0.5));
  if (b.once_in(3)) return text + "    casing: rigid\n";
  return text + fmt::format("    casing: {{mass_kg: {}, stiffness_n_per_m: {}, damping_ratio: {}}}\n",
                            b.number(0.05), b.number(5e5), b.number(0.1));
}

std::string kick(ByteSource& b, bool on_shaft) {
  if (b.once_in(5)) return "";
  std::string text = fmt::format("kick: {{force_n: {}, duration_s: {}", b.number(200), b.number(0.005));
  if (b.once_in(5)) text += fmt::format(", angle_deg: {}", b.number(60));
  if (on_shaft && b.once_in(2)) text += fmt::format(", position_m: {}", b.number(0.23));
  return text + "}\n";
}

/// Chooses a stepper; the automatic choice is the most frequent one.
std::string_view stepper(ByteSource& b) {
  const auto rows = integrate::adaptive::stepper_table();
  const auto number = static_cast<std::size_t>(b.below(static_cast<int>(rows.size()) + 1));
  return rows[number == 0 ? 0 : number - 1].word;
}

/// Two short windows and few steps: a cell ends quickly, whatever its numbers are.
std::string short_run(ByteSource& b) {
  std::string text = fmt::format("solver: {{method: {}, stepper: {}, contact: {}, relative_tolerance: {}, ",
                                 b.one_of({"auto", "auto", "exact", "adaptive"}), stepper(b),
                                 b.one_of({"located", "located", "located", "smoothed"}),
                                 b.one_of({"1e-8", "1e-6", "1e-4", "1e-10"}));
  text += "max_steps_per_revolution: 1000}\n";
  return text + fmt::format(
                    "response: {{max_revolutions: {}, samples_per_revolution: {}, window_revolutions: 4, "
                    "max_order: {}, "
                    "floquet_proof: {}, robustness: {}}}\n",
                    8 + b.below(12), 8 + 4 * b.below(6), 1 + b.below(2), b.one_of({"on", "on", "off"}),
                    b.one_of({"off", "off", "off", "on"}));
}

}  // namespace

std::string random_config(ByteSource& b) {
  const bool on_shaft = b.once_in(2);
  std::string text = (on_shaft ? kit(b) : jeffcott(b)) + "stops:\n";
  const int stops = 1 + (b.once_in(2) ? b.below(3) : 0);
  for (int i = 0; i < stops; ++i) text += stop(b, on_shaft, i);
  text += kick(b, on_shaft);
  if (b.once_in(4)) text += fmt::format("gravity_m_per_s2: {}\n", b.number(9.81));
  text += fmt::format("sweep: {{speed_hz: {{values: [{}]}}, ", b.number(75));
  text += b.once_in(3) ? fmt::format("eccentricity_m: {{values: [{}]}}}}\n", b.number(3e-4))
                       : fmt::format("whirl_ratio: {{values: [{}]}}}}\n", b.number(b.once_in(3) ? 1.2 : 0.4));
  return text + short_run(b) + "output: {directory: out}\n";
}

}  // namespace rubsweep::fuzz
