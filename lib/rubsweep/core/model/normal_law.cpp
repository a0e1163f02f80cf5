#include "rubsweep/core/model/normal_law.hpp"

#include "rubsweep/core/error.hpp"

namespace rubsweep::model {

std::optional<PartProblem> problem_of_curve(const NormalLaw& law) {
  const auto& p = law.penetration_m;
  const auto& f = law.force_n;
  if (p.size() < 2) return PartProblem{"penetration_m", "is no curve", "two numbers or more"};
  if (f.size() != p.size())
    return PartProblem{"force_n", "has not as many numbers as penetration_m", "one for each penetration"};
  if (p.front() != 0) return PartProblem{"penetration_m", "does not begin at 0", "numbers that rise from 0"};
  if (f.front() != 0) return PartProblem{"force_n", "does not begin at 0", "numbers that rise from 0"};
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (!(p[i] > p[i - 1])) return PartProblem{"penetration_m", "does not rise", "numbers that rise from 0"};
    if (!(f[i] > f[i - 1]))
      return PartProblem{"force_n", "falls or stands still", "numbers that rise from 0"};
  }
  return std::nullopt;
}

static_assert(force_curves.values.size() == 4, "validate must know a further law");

void validate(const NormalLaw& law, bool with_hertz, const std::string& path) {
  if (law.kind == ForceCurve::hertz_line && !with_hertz)
    throw ConfigError(path + "kind: hertz_line needs the contact, allowed: with hertz");
  if (law.kind == ForceCurve::table) refuse(problem_of_curve(law), path);
  if (law.kind == ForceCurve::power) {
    require(path + "stiffness_n_per_m_n", law.stiffness_n_per_m_n, positive);
    require(path + "exponent", law.exponent, NormalLaw::exponent_range);
  }
  if (law.linear() || law.damping == ImpactDamping::none) return;
  require(path + "restitution", law.restitution, NormalLaw::restitution_range);
  require(path + "approach_speed_m_per_s", law.approach_speed_m_per_s, positive);
}

}  // namespace rubsweep::model
