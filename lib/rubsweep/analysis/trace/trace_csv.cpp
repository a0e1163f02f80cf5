#include "rubsweep/analysis/trace/trace_csv.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <numbers>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::trace {
namespace {

using batch::csv_number;

void append(std::string& line, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    line += ',';
    line += csv_number(number);
  }
}

void append_rotor(std::string& line, const TraceState& state) {
  append(line, {state.displacement_m.x(), state.displacement_m.y(), state.velocity_m_per_s.x(),
                state.velocity_m_per_s.y()});
}

std::string casing_velocity_columns(std::size_t stops) {
  std::string text;
  for (std::size_t i = 0; i < stops; ++i)
    text += fmt::format(",casing_{0}_vx_m_per_s,casing_{0}_vy_m_per_s", i);
  return text;
}

void append_casing_velocities(std::string& line, const TraceState& state) {
  for (const StopState& stop : state.stops) append(line, {stop.casing_m_per_s.x(), stop.casing_m_per_s.y()});
}

}  // namespace

std::string trajectory_csv(const Trace& trace) {
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
    for (const StopState& stop : state.stops) {
      append(text,
             {stop.casing_m.x(), stop.casing_m.y(), stop.gap_m, stop.normal_force_n, stop.friction_force_n});
    }
    if (trace.twisting) append(text, {state.twist_rad * 180 / std::numbers::pi, state.torque_nm});
    append_casing_velocities(text, state);
    for (Eigen::Index k = 0; k < trace.vibration_coordinates; ++k)
      append(text, {state.coordinates_m(k), state.rates_m_per_s(k)});
    const Energy& energy = state.energy;
    append(text, {energy.kinetic_j, energy.elastic_j, energy.contact_j, energy.forcing_w, energy.damping_w,
                  energy.contact_damping_w, energy.friction_w});
    text += '\n';
  }
  return text;
}

std::string section_csv(const Trace& trace) {
  std::string text = "revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s";
  for (std::size_t i = 0; i < trace.stops; ++i) text += fmt::format(",casing_{0}_x_m,casing_{0}_y_m", i);
  text += casing_velocity_columns(trace.stops) + '\n';
  for (std::size_t revolution = 0; revolution < trace.section.size(); ++revolution) {
    const auto& [time_s, state] = trace.section[revolution];
    text += fmt::format("{}", revolution);
    append(text, {time_s});
    append_rotor(text, state);
    for (const StopState& stop : state.stops) append(text, {stop.casing_m.x(), stop.casing_m.y()});
    append_casing_velocities(text, state);
    text += '\n';
  }
  return text;
}

std::string events_csv(const Trace& trace) {
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

}  // namespace rubsweep::trace
