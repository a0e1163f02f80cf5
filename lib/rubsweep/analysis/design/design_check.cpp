#include "rubsweep/analysis/design/design_check.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/design/design_terms.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {
namespace {

/// Twice the gap at a stop with the rotor in its mean position; at least 0.
double diametral_clearance_m(const scene::PreparedMachine& prepared, std::size_t stop,
                             const WatchedPlace& place, const scene::QuietMotion& motion) {
  const model::Stop& described = prepared.machine.stops[stop];
  const contact::Excursion about = contact::excursion(
      contact::wall_of(described.geometry), described.clearance_m, place.map, motion.mean, motion.amplitude);
  return std::max(0.0, -2 * about.mean);
}

constexpr int campbell_speeds = 101;
constexpr int whip_speeds = 11;

std::vector<ProbeResponse> probe_responses(const scene::PreparedMachine& prepared, Responses& response,
                                           double eccentricity_m, const std::vector<double>& speeds_hz) {
  std::vector<ProbeResponse> probes;
  for (const WatchedPlace& place : probe_places(prepared)) {
    const auto axis_m = [&](double hz) {
      return eccentricity_m * response.major_axis(hz, response.rotor().place(place.position_m));
    };
    probes.push_back({place.position_m, largest_over_speed(speeds_hz, axis_m), place.name});
  }
  return probes;
}

/// Smallest whip margin over some speeds of the operating range.
WhipMargin whip_margin(const scene::PreparedMachine& prepared, std::size_t stop,
                       const SpeedRange& operating) {
  const model::Stop& described = prepared.machine.stops[stop];
  const double fastest_slip_m_per_s = described.contact_radius_m * 2 * std::numbers::pi * operating.to_hz;
  WhipMargin worst{stop, largest_friction(described.friction, fastest_slip_m_per_s), {}};
  for (const double speed_hz : batch::evenly_spaced(operating.from_hz, operating.to_hz, whip_speeds)) {
    const std::optional<DryWhip> found = least_dry_whip(prepared, stop, speed_hz);
    if (found && (!worst.needs || found->least_friction < worst.needs->least_friction)) worst.needs = found;
  }
  return worst;
}

std::vector<ResponseCurve> curves_over(const scene::PreparedMachine& prepared, Responses& response,
                                       double eccentricity_m, const std::vector<double>& speeds_hz) {
  std::vector<ResponseCurve> curves;
  for (const bool probe : {true, false}) {
    std::size_t number = 0;
    for (const WatchedPlace& place : probe ? probe_places(prepared) : stop_places(prepared))
      curves.push_back({probe, number++, place.position_m, speeds_hz, {}});
  }
  for (ResponseCurve& curve : curves)
    for (const double speed_hz : speeds_hz)
      curve.major_axis_m.push_back(eccentricity_m *
                                   response.major_axis(speed_hz, response.rotor().place(curve.position_m)));
  return curves;
}

/// Reason why kicks cannot be tried; empty if they can.
std::string why_no_kicks(const sweep::Study& study, const DesignQuestions& questions) {
  if (questions.kick_speeds == 0) return "not asked for";
  if (!study.machine.kick) return "the configuration has no kick";
  return study.machine.kick->force_n > 0 ? "" : "the kick has no force";
}

std::vector<double> kicked_speeds(const DesignQuestions& questions,
                                  const std::vector<linear::LockSpeed>& locks) {
  const SpeedRange& range = questions.operating;
  std::vector<double> speeds = batch::evenly_spaced(range.from_hz, range.to_hz, questions.kick_speeds);
  for (const linear::LockSpeed& lock : locks) speeds.push_back(lock.speed_hz);
  std::ranges::sort(speeds);
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

void try_kicks(const sweep::Study& study, const scene::PreparedMachine& prepared,
               const DesignQuestions& questions, DesignCheck& check) {
  check.no_kicks = why_no_kicks(study, questions);
  if (!check.no_kicks.empty()) return;
  const std::atomic<bool> never{false};
  check.kicks = kick_thresholds(study, prepared, check.scale * check.eccentricity_m,
                                kicked_speeds(questions, check.locks), questions.threads, never);
}

std::vector<ClearanceMargin> margins_over(const scene::PreparedMachine& prepared, Responses& response,
                                          double eccentricity_m, std::span<const double> speeds_hz) {
  const std::vector<WatchedPlace> places = stop_places(prepared);
  std::vector<ClearanceMargin> margins;
  for (std::size_t stop = 0; stop < places.size(); ++stop) {
    const auto at = [&](double speed_hz) {
      const scene::QuietMotion motion = unit_response(prepared, speed_hz);
      ClearanceMargin found{stop, places[stop].position_m, speed_hz, 0, 0, 0};
      found.major_axis_m =
          eccentricity_m * response.major_axis(speed_hz, response.rotor().place(places[stop].position_m));
      found.diametral_clearance_m = diametral_clearance_m(prepared, stop, places[stop], motion);
      found.margin = found.diametral_clearance_m > 0
                         ? 1 - found.major_axis_m / (clearance_share * found.diametral_clearance_m)
                         : -std::numeric_limits<double>::infinity();
      return found;
    };
    margins.push_back(at(largest_over_speed(speeds_hz, [&](double hz) { return -at(hz).margin; }).speed_hz));
  }
  return margins;
}

/// Critical speeds up to where responses are looked at; growth beyond the whole range goes to the check.
std::vector<linear::CriticalSpeed> look_beyond(const linear::Campbell& modes, const model::Machine& machine,
                                               DesignCheck& check) {
  constexpr int speeds_beyond = 11;
  std::vector<linear::CriticalSpeed> critical = modes.critical_speeds;
  const double to_hz = within_tables_hz(machine, response_up_to * check.whole.to_hz);
  if (to_hz <= check.whole.to_hz) return critical;
  const linear::Campbell beyond = linear::campbell(
      linear::free_rotor(machine), batch::evenly_spaced(check.whole.to_hz, to_hz, speeds_beyond), to_hz);
  critical.insert(critical.end(), beyond.critical_speeds.begin(), beyond.critical_speeds.end());
  double decays_to_hz = check.whole.to_hz;
  for (const linear::GrowthAt& one : beyond.growth) {
    if (one.growth_per_s > check.growth_beyond.growth_per_s) check.growth_beyond = one;
    if (one.growth_per_s > 0 && !check.decays_to_hz) check.decays_to_hz = decays_to_hz;
    decays_to_hz = one.speed_hz;
  }
  return critical;
}

/// Clearances from the maximum continuous speed to trip speed, or to where the tables end.
void add_trip_clearances(const scene::PreparedMachine& prepared, Responses& response, DesignCheck& check) {
  constexpr int speeds = 26;
  const double trip_hz = trip_speed * check.whole.to_hz, to_hz = within_tables_hz(prepared.machine, trip_hz);
  if (to_hz > check.whole.to_hz) {
    const std::vector<double> beyond = batch::evenly_spaced(check.whole.to_hz, to_hz, speeds);
    for (const ClearanceMargin& one :
         margins_over(prepared, response, check.scale * check.eccentricity_m, beyond)) {
      Term term = clearance_term("clearance_to_trip", one, check.stop_names);
      term.met = one.margin >= 0;
      if (check.whole_growth.growth_per_s > 0) refuse_verdict(term, grows_away);
      if (check.decays_to_hz && *check.decays_to_hz < to_hz) refuse_verdict(term, grows_beyond);
      check.lateral.push_back(std::move(term));
    }
  }
  if (to_hz < trip_hz) {
    check.lateral.push_back(untold("clearance_to_trip", trip_hz,
                                   "tables of supports end at " + model::speed_text(to_hz, 5) +
                                       ", the trip speed is " + model::speed_text(trip_hz, 5)));
  }
}

}  // namespace

double vibration_limit_m(double max_continuous_hz) {
  constexpr double slow_rotor_m = 25.4e-6, fastest_slow_rpm = 12000;
  return std::min(slow_rotor_m,
                  slow_rotor_m * std::sqrt(fastest_slow_rpm / (model::rpm_per_hz * max_continuous_hz)));
}

double analysis_eccentricity_m(const model::Machine& machine, double max_continuous_hz) {
  const double g_mm_per_metre = model::g_mm_per_metre(machine);
  if (!(g_mm_per_metre > 0)) {
    throw ConfigError(
        "rotor.discs: no disc stands off the axis, so that there is no unbalance to respond to, allowed: at "
        "least one eccentricity_ratio that is not 0");
  }
  return unbalance_g_mm_rpm_per_kg * model::rotor_mass_kg(machine) / (model::rpm_per_hz * max_continuous_hz) /
         g_mm_per_metre;
}

double scale_factor(double limit_m, double response_m) {
  if (response_m * largest_scale_factor <= limit_m) return largest_scale_factor;
  return std::max(limit_m / response_m, smallest_scale_factor);
}

std::vector<ClearanceMargin> clearance_margins(const scene::PreparedMachine& prepared, double eccentricity_m,
                                               std::span<const double> speeds_hz) {
  const WholeRotor rotor(prepared.machine);
  Responses response(rotor, rotor.configured_kg());
  return margins_over(prepared, response, eccentricity_m, speeds_hz);
}

double WhipMargin::margin() const {
  if (!needs || friction == 0) return 1;
  return 1 - friction / needs->least_friction;
}

const ProbeResponse& DesignCheck::worst_probe() const {
  return *std::ranges::max_element(probes, {},
                                   [](const ProbeResponse& probe) { return probe.major_axis_m.value; });
}

const KickThreshold* DesignCheck::smallest_kick() const {
  const KickThreshold* smallest = nullptr;
  for (const KickThreshold& kick : kicks)
    if (kick.force_n && (smallest == nullptr || *kick.force_n < *smallest->force_n)) smallest = &kick;
  return smallest;
}

SpeedRange whole_range(const model::Machine& machine, const SpeedRange& operating) {
  constexpr double standstill = 1e-3;
  double from_hz = standstill * operating.to_hz;
  if (const model::RotorKit* kit = model::kit_of(machine); kit != nullptr && model::has_tables(*kit))
    from_hz = std::max(from_hz, model::table_speeds_hz(*kit).low);
  return {std::min(from_hz, operating.from_hz), operating.to_hz};
}

DesignCheck check_design(const sweep::Study& study, const scene::PreparedMachine& prepared,
                         const DesignQuestions& questions) {
  DesignCheck check;
  check.stop_names = study.stop_names;
  check.operating = questions.operating;
  check.whole = whole_range(study.machine, questions.operating);
  structure::refuse_beyond_tables(study.machine, check.whole.from_hz, check.whole.to_hz);
  check.eccentricity_m = questions.eccentricity_m ? *questions.eccentricity_m
                                                  : analysis_eccentricity_m(study.machine, check.whole.to_hz);
  check.vibration_limit_m = vibration_limit_m(check.whole.to_hz);
  const linear::Campbell modes = linear::campbell(
      linear::free_rotor(study.machine),
      batch::evenly_spaced(check.whole.from_hz, check.whole.to_hz, campbell_speeds), 2 * check.whole.to_hz);
  for (const linear::GrowthAt& one : modes.growth) {
    if (one.growth_per_s > check.whole_growth.growth_per_s) check.whole_growth = one;
    if (check.operating.contains(one.speed_hz) && one.growth_per_s > check.growth.growth_per_s)
      check.growth = one;
  }
  const std::vector<linear::CriticalSpeed> critical = look_beyond(modes, study.machine, check);
  const std::vector<double> speeds_hz = response_speeds(check.whole, modes.critical_speeds);
  const WholeRotor rotor(prepared.machine);
  Responses response(rotor, rotor.configured_kg());
  check.probes =
      probe_responses(prepared, response, check.eccentricity_m, within(check.operating, speeds_hz));
  check.scale = scale_factor(check.vibration_limit_m, check.worst_probe().major_axis_m.value);
  check.clearances = margins_over(prepared, response, check.scale * check.eccentricity_m, speeds_hz);
  check.curves = curves_over(prepared, response, check.scale * check.eccentricity_m, speeds_hz);
  for (std::size_t stop = 0; stop < study.machine.stops.size(); ++stop) {
    if (contact::annular(contact::wall_of(study.machine.stops[stop].geometry)))
      check.whips.push_back(whip_margin(prepared, stop, check.operating));
  }
  for (const linear::LockSpeed& lock : linear::lock_speeds(modes))
    if (check.operating.contains(lock.speed_hz)) check.locks.push_back(lock);
  add_trip_clearances(prepared, response, check);
  std::ranges::move(
      lateral_terms(prepared, {check.operating, check.whole, check.eccentricity_m, check.scale,
                               check.vibration_limit_m, critical, check.whole_growth.growth_per_s > 0,
                               questions.stages, check.decays_to_hz, questions.gas_density_kg_per_m3}),
      std::back_inserter(check.lateral));
  try_kicks(study, prepared, questions, check);
  return check;
}

}  // namespace rubsweep::design
