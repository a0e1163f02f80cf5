#include "rubsweep/core/response/motion/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubsweep::response::motion {

ContactFacts facts_of(const integrate::run::TurnReport& turn) {
  return {.hits = turn.hits,
          .contact_fraction = turn.contact_fraction,
          .peak_displacement_m = turn.peak_displacement_m,
          .peak_contact_force_n = turn.peak_contact_force_n,
          .peak_casing_displacement_m = turn.peak_casing_displacement_m,
          .peak_twist_rad = turn.peak_twist_rad,
          .peak_torque_nm = turn.peak_torque_nm};
}

ContactFacts together(std::span<const ContactFacts> turns) {
  ContactFacts all;
  for (const ContactFacts& turn : turns) {
    all.hits += turn.hits;
    all.contact_fraction += turn.contact_fraction;
    all.peak_displacement_m = std::max(all.peak_displacement_m, turn.peak_displacement_m);
    all.peak_contact_force_n = std::max(all.peak_contact_force_n, turn.peak_contact_force_n);
    all.peak_casing_displacement_m =
        std::max(all.peak_casing_displacement_m, turn.peak_casing_displacement_m);
    all.peak_twist_rad = std::max(all.peak_twist_rad, turn.peak_twist_rad);
    all.peak_torque_nm = std::max(all.peak_torque_nm, turn.peak_torque_nm);
  }
  if (!turns.empty()) all.contact_fraction /= static_cast<double>(turns.size());
  return all;
}

bool is_finite(const Measures& measures) {
  // Every member has a name here, so that a further one does not compile: `together` must know it, too.
  const auto& [hits, fraction, displacement_m, force_n, casing_m, twist_rad, torque_nm] = measures.contact;
  const std::array facts{displacement_m, force_n, casing_m};
  const auto finite = [](double number) { return std::isfinite(number); };
  return std::ranges::all_of(facts, finite) &&
         std::ranges::all_of(measured_lines,
                             [&](const MeasuredLine& line) { return finite(measures.*line.amplitude_m); });
}

}  // namespace rubsweep::response::motion
