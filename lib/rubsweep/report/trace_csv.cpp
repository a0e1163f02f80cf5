#include "rubsweep/report/trace_csv.hpp"

#include <fmt/format.h>

#include <initializer_list>

#include "rubsweep/batch/csv_table.hpp"

namespace rubsweep::report {
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

}  // namespace

std::string trajectory_header(std::size_t stops) {
  std::string header = "t_s,x_m,y_m,vx_m_per_s,vy_m_per_s";
  for (std::size_t i = 0; i < stops; ++i) {
    header +=
        fmt::format(",casing_{0}_x_m,casing_{0}_y_m,gap_{0}_m,normal_force_{0}_n,friction_force_{0}_n", i);
  }
  return header + "\n";
}

std::string trajectory_line(double time_s, const TraceState& state) {
  std::string line = csv_number(time_s);
  append_rotor(line, state);
  for (const StopState& stop : state.stops) {
    append(line,
           {stop.casing_m.x(), stop.casing_m.y(), stop.gap_m, stop.normal_force_n, stop.friction_force_n});
  }
  return line + "\n";
}

std::string section_header(std::size_t stops) {
  std::string header = "revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s";
  for (std::size_t i = 0; i < stops; ++i) header += fmt::format(",casing_{0}_x_m,casing_{0}_y_m", i);
  return header + "\n";
}

std::string section_line(long revolution, double time_s, const TraceState& state) {
  std::string line = fmt::format("{}", revolution);
  append(line, {time_s});
  append_rotor(line, state);
  for (const StopState& stop : state.stops) append(line, {stop.casing_m.x(), stop.casing_m.y()});
  return line + "\n";
}

std::string events_header() { return "t_s,stop,from,to\n"; }

std::string event_line(double time_s, const integrate::ModeSwitch& change) {
  return fmt::format("{},{},{},{}\n", csv_number(time_s), change.contact, contact::to_string(change.from),
                     contact::to_string(change.to));
}

std::string spectrum_csv(const response::FullSpectrum& spectrum, double speed_hz) {
  std::string text = "order,frequency_hz,amplitude_m\n";
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    const double order = spectrum.order(k);
    text += fmt::format("{},{},{}\n", csv_number(order), csv_number(order * speed_hz),
                        csv_number(spectrum.amplitude(k)));
  }
  return text;
}

}  // namespace rubsweep::report
