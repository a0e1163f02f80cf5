#include "rubsweep/analysis/design/design_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubsweep::design {
namespace {

std::string stop_name(std::size_t stop) { return fmt::format("stop {}", stop); }

std::optional<double> speed_of(const std::optional<DryWhip>& whip) {
  return whip ? std::optional(whip->speed_hz) : std::nullopt;
}

}  // namespace

Term clearance_term(std::string check, const ClearanceMargin& margin) {
  return {std::move(check),
          stop_name(margin.stop),
          margin.position_m,
          margin.speed_hz,
          margin.major_axis_m,
          clearance_share * margin.diametral_clearance_m,
          "m",
          std::isfinite(margin.margin) ? std::optional(margin.margin) : std::nullopt};
}

std::vector<Term> terms_of(const DesignCheck& check) {
  std::vector<Term> terms;
  // While a free vibration grows, the steady response does not last. A limit that it meets is no verdict.
  const auto if_lasting = [](bool met, const linear::GrowthAt& growth) {
    return !met || growth.growth_per_s == 0 ? std::optional(met) : std::nullopt;
  };
  for (std::size_t k = 0; k < check.probes.size(); ++k) {
    const ProbeResponse& probe = check.probes[k];
    const double margin = 1 - probe.major_axis_m.value / check.vibration_limit_m;
    terms.push_back({"vibration", fmt::format("probe {}", k), probe.position_m, probe.major_axis_m.speed_hz,
                     probe.major_axis_m.value, check.vibration_limit_m, "m", margin,
                     if_lasting(margin >= 0, check.growth), {}, probe.name});
  }
  for (const ClearanceMargin& one : check.clearances) {
    terms.push_back(clearance_term("clearance", one));
    terms.back().met = if_lasting(one.margin >= 0, check.whole_growth);
  }
  for (const WhipMargin& one : check.whips) {
    terms.push_back({"dry_whip",
                     stop_name(one.stop),
                     {},
                     speed_of(one.needs),
                     one.friction,
                     one.needs ? std::optional(one.needs->least_friction) : std::nullopt,
                     "1",
                     one.margin(),
                     one.margin() > 0});
  }
  const bool grows = check.growth.growth_per_s > 0;
  terms.push_back({"stability",
                   "",
                   {},
                   grows ? std::optional(check.growth.speed_hz) : std::nullopt,
                   check.growth.growth_per_s,
                   0.0,
                   "1/s",
                   {},
                   !grows});
  terms.insert(terms.end(), check.lateral.begin(), check.lateral.end());
  if (const KickThreshold* kick = check.smallest_kick(); kick != nullptr)
    terms.push_back({"kick", "", {}, kick->speed_hz, *kick->force_n, {}, "N"});
  return terms;
}

Answer answer_of(const DesignCheck& check) {
  const std::vector<Term> terms = terms_of(check);
  if (std::ranges::any_of(terms, [](const Term& term) { return term.met == false; })) return Answer::not_met;
  return check.whole_growth.growth_per_s > 0 ||
                 std::ranges::any_of(terms,
                                     [](const Term& term) {
                                       return !term.not_told.empty() && !term.check.starts_with("level_1");
                                     })
             ? Answer::not_told
             : Answer::pass;
}

}  // namespace rubsweep::design
