#include "rubsweep/maps/report/explain_law.hpp"

#include <fmt/format.h>

#include <string_view>

#include "rubsweep/core/contact/curved_law.hpp"

namespace rubsweep::report {

std::string explain_law(const model::Stop& stop) {
  const model::NormalLaw& law = stop.law;
  const contact::CurvedLaw curve(stop);
  std::string text = "  force law: ";
  if (law.kind == model::ForceCurve::power)
    text += fmt::format("{} N/m^{} p^{}", law.stiffness_n_per_m_n, law.exponent, law.exponent);
  if (law.kind == model::ForceCurve::hertz_line) text += "line contact of Hertz as it is";
  if (law.kind == model::ForceCurve::table)
    text += fmt::format("measured curve of {} points up to {} m, beyond that its tangent", law.force_n.size(),
                        law.penetration_m.back());
  text += fmt::format("; secant at a twentieth of the clearance {:.4g} N/m\n", stop.stiffness_n_per_m);
  if (curve.factor() == 0) return text + "  contact damping: none\n";
  std::string_view damping;
  for (std::size_t i = 0; i < model::impact_dampings.values.size(); ++i)
    if (model::impact_dampings.values[i] == law.damping) damping = model::impact_dampings.texts[i];
  text += fmt::format("  contact damping: {} with restitution {}, 1 + {:.6g} p' / v0, v0 {}\n", damping,
                      law.restitution, curve.factor(),
                      law.approach_speed_m_per_s ? fmt::format("{} m/s", *law.approach_speed_m_per_s)
                                                 : "the speed of each approach");
  text += fmt::format("    a free impact with v0 returns {:.4g} of it\n",
                      contact::restitution_of_factor(curve.factor()));
  if (curve.remembers())
    text +=
        "    the motion goes by how each contact began: no proof of a period, no exponent, two windows "
        "decide\n";
  return text;
}

}  // namespace rubsweep::report
