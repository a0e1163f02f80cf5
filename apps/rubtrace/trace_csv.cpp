#include "trace_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <numbers>

#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {
namespace {

using batch::csv_number;
using model::LengthUnit;
using response::spectrum::SpectralLine;

std::string peaks(const response::motion::ContactFacts& facts, double clearance_m,
                  const model::ShownLengths& shown) {
  const std::string length =
      shown.unit ? ", " + model::length_text(facts.peak_displacement_m, shown, LengthUnit::m) : std::string();
  return fmt::format("{:.4g} clearances{}, {:.4g} N", facts.peak_displacement_m / clearance_m, length,
                     facts.peak_contact_force_n);
}

std::string lines_text(const std::vector<SpectralLine>& lines, const model::ShownLengths& shown) {
  std::string text;
  for (const SpectralLine& line : lines) {
    text += fmt::format("{}{:+.4g}X {}", text.empty() ? "" : ", ", line.order,
                        model::amplitude_text(line.amplitude_m, shown, LengthUnit::m));
  }
  return text.empty() ? "none" : text;
}

std::string effort_text(const integrate::run::Effort& effort, long revolutions) {
  const auto per_turn = [&](long count) {
    return static_cast<double>(count) / static_cast<double>(revolutions);
  };
  std::string text = fmt::format(
      "{:.1f} right-hand sides, {:.1f} steps, {:.1f} refused, {:.2f} mode switches per revolution",
      per_turn(effort.rhs_calls), per_turn(effort.steps), per_turn(effort.refused),
      per_turn(effort.switches));
  if (effort.taylor_turns > 0) {
    const auto pieces = static_cast<double>(effort.taylor_pieces);
    text += fmt::format("; {} revolutions with Taylor pieces, {:.1f} in each", effort.taylor_turns,
                        pieces / static_cast<double>(effort.taylor_turns));
    if (effort.creep_pieces > 0)
      text +=
          fmt::format(", {:.2g} % of them of creep", 100 * static_cast<double>(effort.creep_pieces) / pieces);
  }
  if (effort.adaptive_turns > 0) text += fmt::format("; {} revolutions by a stepper", effort.adaptive_turns);
  return text;
}

void append(std::string& line, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    line += ',';
    line += csv_number(number);
  }
}

void append_rotor(std::string& line, const trace::TraceState& state) {
  append(line, {state.displacement_m.x(), state.displacement_m.y(), state.velocity_m_per_s.x(),
                state.velocity_m_per_s.y()});
}

std::string casing_velocity_columns(std::size_t stops) {
  std::string text;
  for (std::size_t i = 0; i < stops; ++i)
    text += fmt::format(",casing_{0}_vx_m_per_s,casing_{0}_vy_m_per_s", i);
  return text;
}

void append_casing_velocities(std::string& line, const trace::TraceState& state) {
  for (const trace::StopState& stop : state.stops)
    append(line, {stop.casing_m_per_s.x(), stop.casing_m_per_s.y()});
}

}  // namespace

std::string trace_summary(const trace::Trace& trace, const trace::TraceWindow& window, double clearance_m,
                          const model::ShownLengths& shown) {
  std::string run = fmt::format("run       {} revolutions, {}\n", trace.revolutions,
                                trace.last_contact_revolution ? fmt::format("last contact in revolution {}",
                                                                            *trace.last_contact_revolution)
                                                              : "no contact");
  if (window.turns == 0) return run;
  const response::motion::ContactFacts whole = facts_of_last(trace, trace.turns.size());
  return run + fmt::format(
                   "peak      {}; {} in the last {} revolutions\n"
                   "contact   {:.4g} hits per revolution, {:.3g} % of the time, in the last {} revolutions\n"
                   "lines     {}\n"
                   "effort    {}\n",
                   peaks(whole, clearance_m, shown), peaks(window.contact, clearance_m, shown), window.turns,
                   static_cast<double>(window.contact.hits) / window.turns,
                   100 * window.contact.contact_fraction, window.turns,
                   lines_text(largest_lines(window.spectrum, 5, clearance_m), shown),
                   effort_text(trace.effort, trace.revolutions));
}

std::string probe_summary(const trace::ProbePeriod& period, const trace::ProbePair& pair,
                          const trace::Probes& probes, const model::ShownLengths& shown) {
  const std::string what = period.period
                               ? *period.period == 1 ? std::string("repeats every turn")
                                                     : fmt::format("repeats after {} turns", *period.period)
                               : std::string("repeats after none of the numbers of turns looked for");
  const auto label = [&](std::size_t i) {
    return model::sensor_label(i, model::name_at(probes.name, i), probes.angle_deg[i]);
  };
  return fmt::format(
      "probes    {} by {} readings of sensors {} and {} every {:g} s, noise {}: "
      "{:.2g} % of the energy off the lines, {:.2g} % allowed\n",
      what, period.readings, label(pair.first), label(pair.second), probes.sample_s,
      model::length_text(probes.noise_m(), shown, LengthUnit::m, 6), 100 * period.unexplained_share,
      100 * period.allowed_share);
}

std::vector<SpectralLine> largest_lines(const response::spectrum::FullSpectrum& spectrum, std::size_t count,
                                        double clearance_m) {
  const int first = spectrum.first_line(), last = spectrum.last_line();
  const auto amplitude = [&](int k) { return k < first || k > last || k == 0 ? 0.0 : spectrum.amplitude(k); };
  std::vector<SpectralLine> lines;
  for (int k = first; k <= last; ++k) {
    // Where two neighbouring lines are equal, the first one counts as the maximum.
    if (amplitude(k) > amplitude(k - 1) && amplitude(k) >= amplitude(k + 1)) {
      lines.push_back({spectrum.order(k), amplitude(k)});
    }
  }
  std::ranges::stable_sort(lines, std::ranges::greater{}, &SpectralLine::amplitude_m);
  if (lines.empty()) return lines;
  const double floor_m = std::max(response::motion::significant_share_of_largest * lines.front().amplitude_m,
                                  response::motion::significant_share_of_clearance * clearance_m);
  while (!lines.empty() && lines.back().amplitude_m <= floor_m) lines.pop_back();
  if (lines.size() > count) lines.resize(count);
  return lines;
}

std::string trajectory_csv(const trace::Trace& trace) {
  std::string text = "t_s,x_m,y_m,vx_m_per_s,vy_m_per_s";
  for (std::size_t i = 0; i < trace.stops; ++i) {
    text +=
        fmt::format(",casing_{0}_x_m,casing_{0}_y_m,gap_{0}_m,normal_force_{0}_n,friction_force_{0}_n", i);
  }
  if (trace.twisting) text += ",twist_deg,torque_nm";
  text += casing_velocity_columns(trace.stops);
  for (Eigen::Index k = 0; k < trace.vibration_coordinates; ++k)
    text += fmt::format(",coordinate_{0}_m,coordinate_{0}_m_per_s", k);
  text +=
      ",kinetic_energy_j,elastic_energy_j,contact_energy_j,forcing_power_w,damping_power_w,"
      "contact_damping_power_w,friction_power_w\n";
  for (const auto& [time_s, state] : trace.trajectory) {
    text += csv_number(time_s);
    append_rotor(text, state);
    for (const trace::StopState& stop : state.stops) {
      append(text,
             {stop.casing_m.x(), stop.casing_m.y(), stop.gap_m, stop.normal_force_n, stop.friction_force_n});
    }
    if (trace.twisting) append(text, {state.twist_rad * 180 / std::numbers::pi, state.torque_nm});
    append_casing_velocities(text, state);
    for (Eigen::Index k = 0; k < trace.vibration_coordinates; ++k)
      append(text, {state.coordinates_m(k), state.rates_m_per_s(k)});
    const trace::Energy& energy = state.energy;
    append(text, {energy.kinetic_j, energy.elastic_j, energy.contact_j, energy.forcing_w, energy.damping_w,
                  energy.contact_damping_w, energy.friction_w});
    text += '\n';
  }
  return text;
}

std::string section_csv(const trace::Trace& trace) {
  std::string text = "revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s";
  for (std::size_t i = 0; i < trace.stops; ++i) text += fmt::format(",casing_{0}_x_m,casing_{0}_y_m", i);
  text += casing_velocity_columns(trace.stops) + '\n';
  for (std::size_t revolution = 0; revolution < trace.section.size(); ++revolution) {
    const auto& [time_s, state] = trace.section[revolution];
    text += fmt::format("{}", revolution);
    append(text, {time_s});
    append_rotor(text, state);
    for (const trace::StopState& stop : state.stops) append(text, {stop.casing_m.x(), stop.casing_m.y()});
    append_casing_velocities(text, state);
    text += '\n';
  }
  return text;
}

std::string events_csv(const trace::Trace& trace) {
  std::string text = "t_s,stop,from,to\n";
  for (const auto& [time_s, change] : trace.switches) {
    text += fmt::format("{},{},{},{}\n", csv_number(time_s), change.contact, contact::to_string(change.from),
                        contact::to_string(change.to));
  }
  return text;
}

std::string spectrum_csv(const response::spectrum::FullSpectrum& spectrum, double speed_hz) {
  std::string text = "order,frequency_hz,amplitude_m\n";
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    const double order = spectrum.order(k);
    text += fmt::format("{},{},{}\n", csv_number(order), csv_number(order * speed_hz),
                        csv_number(spectrum.amplitude(k)));
  }
  return text;
}

}  // namespace rubsweep::apps
