#include "rubsweep/analysis/design/lateral_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rubsweep/analysis/design/critical_map.hpp"
#include "rubsweep/analysis/design/separation.hpp"
#include "rubsweep/analysis/design/static_line.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {
namespace {

using Eigen::Index;

/// Terms of one resonance: its amplification, and how far from the operating range it must be.
void add_resonance(const Resonance& peak, const SpeedRange& operating, const std::string& place,
                   std::optional<double> position_m, std::vector<Term>& terms) {
  const bool damped = peak.amplification.value_or(peak.amplification_below) < critically_damped;
  if (peak.amplification)
    terms.push_back({"amplification", place, position_m, peak.speed_hz, peak.amplification, {}, "1"});
  Term term{"separation", place, position_m, peak.speed_hz, separation(operating, peak.speed_hz), 0.0, "1"};
  if (damped) {
    term.met = true;
  } else if (!peak.amplification) {
    term.limit.reset();
    term.not_told = "the response does not fall to its half power beside this peak";
  } else {
    // For a resonance inside the range, the requirement of the nearer end holds.
    const bool above = operating.to_hz - peak.speed_hz < peak.speed_hz - operating.from_hz;
    term.limit = required_separation(*peak.amplification, above);
    term.margin = *term.value - *term.limit;
    term.met = *term.margin >= 0;
  }
  terms.push_back(std::move(term));
}

void add_responses(const scene::PreparedMachine& prepared, const WholeRotor& rotor,
                   const LateralQuestions& asked, std::vector<Term>& terms) {
  const std::vector<UnbalanceCase> cases = rotor.cases(asked.eccentricity_m, asked.whole.to_hz);
  Eigen::MatrixXcd unbalance_kg_m(rotor.configured_kg().size(), cases.size());
  for (std::size_t k = 0; k < cases.size(); ++k)
    unbalance_kg_m.col(static_cast<Index>(k)) = cases[k].unbalance_kg_m;
  Responses responses(rotor, std::move(unbalance_kg_m));
  const double highest_hz = response_up_to * asked.whole.to_hz,
               to_hz = within_tables_hz(prepared.machine, highest_hz);
  const std::vector<double> speeds_hz = response_speeds({asked.whole.from_hz, to_hz}, asked.critical_speeds),
                            operating_hz = within(asked.operating, speeds_hz);
  const std::vector<WatchedPlace> probes = probe_places(prepared);
  for (std::size_t number = 0; number < cases.size(); ++number) {
    for (std::size_t k = 0; k < probes.size(); ++k) {
      const Index place = rotor.place(probes[k].position_m);
      const std::size_t before = terms.size();
      const std::string name = fmt::format("{} at probe {}", cases[number].name, k);
      const auto axis_m = [&](double hz) {
        return responses.major_axis(hz, place, static_cast<Index>(number));
      };
      if (number > 0) {
        const Largest largest = largest_over_speed(operating_hz, axis_m);
        const double margin = 1 - largest.value / asked.vibration_limit_m;
        terms.push_back({"response", name, probes[k].position_m, largest.speed_hz, largest.value,
                         asked.vibration_limit_m, "m", margin, margin >= 0});
      }
      for (const Resonance& peak : resonances(speeds_hz, axis_m))
        add_resonance(peak, asked.operating, name, probes[k].position_m, terms);
      for (std::size_t i = before; i < terms.size(); ++i) terms[i].name = probes[k].name;
    }
  }
  if (to_hz < highest_hz) {
    terms.push_back(
        untold("separation", highest_hz,
               fmt::format("tables of supports end at {}, 125 % of the maximum continuous speed is {}",
                           model::speed_text(to_hz, 5), model::speed_text(highest_hz, 5))));
  }
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit != nullptr && model::has_tables(*kit) &&
      asked.whole.from_hz > (1 - largest_separation_below) * asked.operating.from_hz) {
    terms.push_back(untold("separation", asked.whole.from_hz,
                           fmt::format("tables of supports begin at {}, the lowest operating speed is {}",
                                       model::speed_text(asked.whole.from_hz, 5),
                                       model::speed_text(asked.operating.from_hz, 5))));
  }
  for (const Bearing& bearing : rotor.bearings()) {
    const auto force_n = [&](double hz) {
      return asked.scale * rotor.bearing_force_n(bearing, responses.at(hz).col(0), hz);
    };
    const Largest largest = largest_over_speed(operating_hz, force_n);
    const std::string place = fmt::format("support {}", bearing.support);
    terms.push_back(
        {"bearing_force", place, bearing.position_m, largest.speed_hz, largest.value, std::nullopt, "N"});
    terms.back().name = model::support_name(*model::kit_of(prepared.machine), bearing.support);
  }
}

/// Term of a pure number that must reach a limit.
Term at_least(double limit, std::string check, double speed_hz, double value) {
  const double margin = value / limit - 1;
  return {std::move(check), "", std::nullopt, speed_hz, value, limit, "1", margin, margin >= 0};
}

Term decrement_term(std::string check, const std::optional<Decrement>& found) {
  if (found) return at_least(least_decrement, std::move(check), found->speed_hz, found->decrement);
  return untold(
      std::move(check), {},
      "no forward whirl of less than half of critical damping up to twice the maximum continuous speed");
}

/// The machine without its seals; unchanged where no bearing would remain.
model::Machine bare_machine(model::Machine machine) {
  if (model::RotorKit* kit = model::kit_of(machine))
    if (model::RotorKit bare = without_seals(*kit); !bare.supports.empty()) *kit = std::move(bare);
  return machine;
}

/// Removes the verdict of a failed Level I, because Level II then decides.
Term no_verdict_if_failed(Term term) {
  if (term.met == false) {
    term.met.reset();
    term.margin.reset();
  }
  return term;
}

/// Threshold of cross-coupling by that of all stages.
Term threshold_term(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz, Index place,
                    double coupling_n_per_m) {
  const std::string check = "level_1_threshold";
  const auto threshold = threshold_n_per_m(rotor, speed_hz, up_to_hz, place);
  if (!threshold) return untold(check, speed_hz, "no forward whirl that cross-coupling makes grow");
  return no_verdict_if_failed(
      at_least(least_threshold_ratio, check, speed_hz, *threshold / coupling_n_per_m));
}

/// Region A or B of Level I, without a verdict: Level II is computed in either.
Term region_term(const model::Machine& machine, double speed_hz, double gas_density_kg_per_m3) {
  const std::optional<double> rigid_hz = rigid_critical_hz(machine);
  if (!rigid_hz)
    return untold("level_1_region", speed_hz, "the rotor has no critical speed on rigid bearings");
  const double limit = region_limit(gas_density_kg_per_m3);
  Term term{"level_1_region", "", {}, speed_hz, speed_hz / *rigid_hz, limit, "1"};
  term.name = *term.value > *term.limit ? "region B" : "region A";
  return term;
}

void add_stability(const WholeRotor& rotor, const model::Machine& machine, const LateralQuestions& asked,
                   std::vector<Term>& terms) {
  constexpr int decrement_speeds = 11;
  const double speed_hz = asked.operating.to_hz, up_to_hz = 2 * speed_hz;
  const Index midspan = rotor.midspan();
  const std::optional<double> position_m =
      model::kit_of(machine) == nullptr
          ? std::nullopt
          : std::optional(rotor.rotor().position_m[static_cast<std::size_t>(midspan)]);
  double coupling = 0;
  for (const Stage& stage : asked.stages.value_or(std::vector<Stage>{}))
    coupling += cross_coupling_n_per_m(stage, speed_hz);
  if (!asked.stages) {
    terms.push_back(
        untold("cross_coupling", speed_hz,
               "no --stage says which power drives cross-coupling, or --stage none that none does"));
    terms.back().position_m = position_m;
  } else if (coupling > 0) {
    const linear::FreeRotor level_one = linear::free_rotor(bare_machine(machine));
    terms.push_back({"cross_coupling", "", position_m, speed_hz, coupling, {}, "N/m"});
    Term first = decrement_term("level_1",
                                first_forward(level_one, std::vector{speed_hz}, up_to_hz, midspan, coupling));
    first.position_m = position_m;
    terms.push_back(no_verdict_if_failed(std::move(first)));
    terms.push_back(threshold_term(level_one, speed_hz, up_to_hz, midspan, coupling));
    terms.back().position_m = position_m;
    if (asked.gas_density_kg_per_m3)
      terms.push_back(region_term(machine, speed_hz, *asked.gas_density_kg_per_m3));
  }
  const std::vector<double> speeds_hz =
      batch::evenly_spaced(asked.operating.from_hz, asked.operating.to_hz, decrement_speeds);
  const auto least = first_forward(rotor.rotor(), speeds_hz, up_to_hz, midspan, coupling);
  terms.push_back(decrement_term("level_2", least));
}

}  // namespace

Term untold(std::string check, std::optional<double> speed_hz, std::string why) {
  Term term{std::move(check), "", {}, speed_hz};
  term.not_told = std::move(why);
  return term;
}

void refuse_verdict(Term& term, const char* why) {
  if (term.met != true) return;
  term.met.reset();
  term.not_told = why;
}

double within_tables_hz(const model::Machine& machine, double up_to_hz) {
  const model::RotorKit* kit = model::kit_of(machine);
  return kit != nullptr ? std::min(up_to_hz, model::table_speeds_hz(*kit).high) : up_to_hz;
}

std::vector<Term> lateral_terms(const scene::PreparedMachine& prepared, const LateralQuestions& questions) {
  const WholeRotor rotor(prepared.machine);
  std::vector<Term> terms;
  add_responses(prepared, rotor, questions, terms);
  for (Term& term : terms) {
    if (questions.grows) {
      refuse_verdict(term, grows_away);
    } else if (questions.decays_to_hz && term.speed_hz.value_or(0) > *questions.decays_to_hz) {
      refuse_verdict(term, grows_beyond);
    }
  }
  add_stability(rotor, prepared.machine, questions, terms);
  return terms;
}

}  // namespace rubsweep::design
