#include "rubsweep/analysis/design/lateral_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "rubsweep/analysis/design/separation.hpp"
#include "rubsweep/analysis/design/static_line.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {
namespace {

using Eigen::Index;

/// Responses of all cases, cached by speed, because the searches for peaks need some speeds more than once.
class Responses {
 public:
  Responses(const WholeRotor& rotor, const std::vector<UnbalanceCase>& cases)
      : rotor_(rotor), unbalance_(rotor.rotor().full.system.coordinates(), cases.size()) {
    for (std::size_t k = 0; k < cases.size(); ++k)
      unbalance_.col(static_cast<Index>(k)) = cases[k].unbalance_kg_m;
  }

  const Eigen::MatrixXcd& at(double speed_hz) {
    const auto found = known_.find(speed_hz);
    if (found != known_.end()) return found->second;
    return known_.emplace(speed_hz, rotor_.response(unbalance_, speed_hz)).first->second;
  }

  double major_axis_m(double speed_hz, Index place, std::size_t number) {
    const auto& rotor = rotor_.rotor();
    const Eigen::VectorXcd q = at(speed_hz).col(static_cast<Index>(number));
    return major_axis({(rotor.x.row(place) * q).value(), (rotor.y.row(place) * q).value()});
  }

 private:
  const WholeRotor& rotor_;
  Eigen::MatrixXcd unbalance_;
  std::map<double, Eigen::MatrixXcd> known_;
};

/// Adds the terms of one resonance: its amplification, and its required distance from the operating range.
void add_resonance(const Resonance& peak, const SpeedRange& operating, const std::string& place,
                   std::optional<double> position_m, std::vector<Term>& terms) {
  const bool damped = peak.amplification ? *peak.amplification < critically_damped
                                         : peak.amplification_below < critically_damped;
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

/// Speeds of the response: those of the whole range, and further speeds up to `to_hz`.
std::vector<double> speeds_up_to(double to_hz, const linear::FreeRotor& rotor,
                                 const LateralQuestions& asked) {
  constexpr int speeds_beyond = 11;
  std::vector<linear::CriticalSpeed> critical = asked.critical_speeds;
  if (to_hz > asked.whole.to_hz) {
    const linear::Campbell beyond =
        linear::campbell(rotor, batch::evenly_spaced(asked.whole.to_hz, to_hz, speeds_beyond), to_hz);
    critical.insert(critical.end(), beyond.critical_speeds.begin(), beyond.critical_speeds.end());
  }
  return response_speeds({asked.whole.from_hz, to_hz}, critical);
}

void add_responses(const scene::PreparedMachine& prepared, const WholeRotor& rotor,
                   const LateralQuestions& asked, std::vector<Term>& terms) {
  const std::vector<UnbalanceCase> cases = rotor.cases(asked.eccentricity_m, asked.whole.to_hz);
  Responses responses(rotor, cases);
  const double highest_hz = response_up_to * asked.whole.to_hz,
               to_hz = within_tables_hz(prepared.machine, highest_hz);
  const std::vector<double> speeds_hz = speeds_up_to(to_hz, rotor.rotor(), asked),
                            operating_hz = within(asked.operating, speeds_hz);
  const std::vector<WatchedPlace> probes = probe_places(prepared);
  for (std::size_t number = 0; number < cases.size(); ++number) {
    for (std::size_t k = 0; k < probes.size(); ++k) {
      const Index place = rotor.place(probes[k].position_m);
      const std::string name = fmt::format("{} at probe {}", cases[number].name, k);
      const auto axis_m = [&](double hz) { return responses.major_axis_m(hz, place, number); };
      if (number > 0) {
        const Largest largest = largest_over_speed(operating_hz, axis_m);
        const double margin = 1 - largest.value / asked.vibration_limit_m;
        terms.push_back({"response", name, probes[k].position_m, largest.speed_hz, largest.value,
                         asked.vibration_limit_m, "m", margin, margin >= 0});
      }
      for (const Resonance& peak : resonances(speeds_hz, axis_m))
        add_resonance(peak, asked.operating, name, probes[k].position_m, terms);
    }
  }
  if (to_hz < highest_hz) {
    Term term{"separation", "", {}, highest_hz};
    term.not_told = fmt::format("tables of supports end at {}, 125 % of the maximum continuous speed is {}",
                                model::speed_text(to_hz, 5), model::speed_text(highest_hz, 5));
    terms.push_back(std::move(term));
  }
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit != nullptr && model::has_tables(*kit) &&
      asked.whole.from_hz > (1 - largest_separation_below) * asked.operating.from_hz) {
    Term term{"separation", "", {}, asked.whole.from_hz};
    term.not_told =
        fmt::format("tables of supports begin at {}, the lowest operating speed is {}",
                    model::speed_text(asked.whole.from_hz, 5), model::speed_text(asked.operating.from_hz, 5));
    terms.push_back(std::move(term));
  }
  for (const Bearing& bearing : rotor.bearings()) {
    const auto force_n = [&](double hz) {
      return asked.scale * rotor.bearing_force_n(bearing, responses.at(hz).col(0), hz);
    };
    const Largest largest = largest_over_speed(operating_hz, force_n);
    terms.push_back({"bearing_force",
                     fmt::format("support {}", bearing.support),
                     bearing.position_m,
                     largest.speed_hz,
                     largest.value,
                     {},
                     "N"});
  }
}

Term decrement_term(std::string check, const std::optional<Decrement>& found) {
  Term term{std::move(check), ""};
  if (!found) {
    term.not_told = "no forward whirl up to twice the maximum continuous speed";
    return term;
  }
  term.speed_hz = found->speed_hz;
  term.value = found->decrement;
  term.limit = least_decrement;
  term.unit = "1";
  term.margin = found->decrement / least_decrement - 1;
  term.met = *term.margin >= 0;
  return term;
}

/// The machine without its seals; unchanged where no bearing would remain.
model::Machine without_seals(const model::Machine& machine) {
  model::Machine bare = machine;
  model::RotorKit* kit = model::kit_of(bare);
  if (kit == nullptr) return bare;
  const model::RotorKit whole = *kit;
  kit->supports.clear();
  for (std::size_t i = 0; i < whole.supports.size(); ++i)
    if (whole.supports[i].at_housing || !is_seal(whole, i)) kit->supports.push_back(whole.supports[i]);
  return kit->supports.empty() ? machine : bare;
}

/// Removes the verdict of a failed Level I, because Level II then decides.
Term no_verdict_if_failed(Term term) {
  if (term.met == false) {
    term.met.reset();
    term.margin.reset();
  }
  term.not_told.clear();
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
    Term term{"cross_coupling", "", position_m, speed_hz};
    term.not_told = "no --stage says which power drives cross-coupling, or --stage none that none does";
    terms.push_back(std::move(term));
  } else if (coupling > 0) {
    const linear::FreeRotor level_one = linear::free_rotor(without_seals(machine));
    terms.push_back({"cross_coupling", "", position_m, speed_hz, coupling, {}, "N/m"});
    Term first = decrement_term("level_1",
                                first_forward(level_one, std::vector{speed_hz}, up_to_hz, midspan, coupling));
    first.position_m = position_m;
    terms.push_back(no_verdict_if_failed(std::move(first)));
    if (const auto threshold = threshold_n_per_m(level_one, speed_hz, up_to_hz, midspan)) {
      const double ratio = *threshold / coupling, margin = ratio / least_threshold_ratio - 1;
      terms.push_back(no_verdict_if_failed({"level_1_threshold", "", position_m, speed_hz, ratio,
                                            least_threshold_ratio, "1", margin, margin >= 0}));
    }
  }
  const std::vector<double> speeds_hz =
      batch::evenly_spaced(asked.operating.from_hz, asked.operating.to_hz, decrement_speeds);
  const auto least = first_forward(rotor.rotor(), speeds_hz, up_to_hz, midspan, coupling);
  terms.push_back(decrement_term("level_2", least));
}

}  // namespace

double within_tables_hz(const model::Machine& machine, double up_to_hz) {
  const model::RotorKit* kit = model::kit_of(machine);
  return kit != nullptr && model::has_tables(*kit) ? std::min(up_to_hz, model::table_speeds_hz(*kit).high)
                                                   : up_to_hz;
}

std::vector<Term> lateral_terms(const scene::PreparedMachine& prepared, const LateralQuestions& questions) {
  const WholeRotor rotor(prepared.machine);
  std::vector<Term> terms;
  add_responses(prepared, rotor, questions, terms);
  for (Term& term : terms) {
    if (!questions.grows || term.met != true) continue;
    term.met.reset();
    term.not_told = grows_away;
  }
  add_stability(rotor, prepared.machine, questions, terms);
  return terms;
}

}  // namespace rubsweep::design
