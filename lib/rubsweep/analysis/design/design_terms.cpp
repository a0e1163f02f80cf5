#include "rubsweep/analysis/design/design_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/model/element_name.hpp"

namespace rubsweep::design {
namespace {

std::string stop_name(std::size_t stop) { return fmt::format("stop {}", stop); }

}  // namespace

Term clearance_term(std::string check, const ClearanceMargin& margin,
                    const std::vector<std::string>& stop_names) {
  Term term{std::move(check), stop_name(margin.stop), margin.position_m, margin.speed_hz,
            margin.major_axis_m};
  term.limit = clearance_share * margin.diametral_clearance_m;
  term.unit = "m";
  if (std::isfinite(margin.margin)) term.margin = margin.margin;
  term.name = model::name_at(stop_names, margin.stop);
  return term;
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
                     if_lasting(margin >= 0, check.growth)});
    terms.back().name = probe.name;
  }
  for (const ClearanceMargin& one : check.clearances) {
    terms.push_back(clearance_term("clearance", one, check.stop_names));
    terms.back().met = if_lasting(one.margin >= 0, check.whole_growth);
  }
  for (const WhipMargin& one : check.whips) {
    Term& term = terms.emplace_back(Term{"dry_whip", stop_name(one.stop), {}, {}, one.friction});
    if (one.needs) {
      term.speed_hz = one.needs->speed_hz;
      term.limit = one.needs->least_friction;
    }
    term.unit = "1";
    term.margin = one.margin();
    term.met = one.margin() > 0;
    term.name = model::name_at(check.stop_names, one.stop);
  }
  Term& stability = terms.emplace_back(Term{"stability", "", {}, {}, check.growth.growth_per_s, 0.0, "1/s"});
  stability.met = !(check.growth.growth_per_s > 0);
  if (!*stability.met) stability.speed_hz = check.growth.speed_hz;
  terms.insert(terms.end(), check.lateral.begin(), check.lateral.end());
  if (const KickThreshold* kick = check.smallest_kick(); kick != nullptr)
    terms.push_back({"kick", "", {}, kick->speed_hz, *kick->force_n, {}, "N"});
  return terms;
}

Answer answer_of(const DesignCheck& check) {
  const std::vector<Term> terms = terms_of(check);
  if (std::ranges::any_of(terms, [](const Term& term) { return term.met == false; })) return Answer::not_met;
  const bool unknown = std::ranges::any_of(
      terms, [](const Term& term) { return !term.not_told.empty() && !term.check.starts_with("level_1"); });
  return unknown || check.whole_growth.growth_per_s > 0 ? Answer::not_told : Answer::pass;
}

}  // namespace rubsweep::design
