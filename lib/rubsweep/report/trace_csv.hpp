#pragma once

#include <cstddef>
#include <string>

#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/report/trace_state.hpp"
#include "rubsweep/response/full_spectrum.hpp"

namespace rubsweep::report {

/// The tables of one traced run, as texts whose lines all have their end. Stops count from 0, as in the
/// configuration. Times are seconds since the start of the kick.

/// t_s, x_m, y_m, vx_m_per_s, vy_m_per_s, then per stop casing_i_x_m, casing_i_y_m, gap_i_m,
/// normal_force_i_n, friction_force_i_n.
std::string trajectory_header(std::size_t stops);
std::string trajectory_line(double time_s, const TraceState& state);

/// revolution, t_s, x_m, y_m, vx_m_per_s, vy_m_per_s, then per stop casing_i_x_m, casing_i_y_m.
std::string section_header(std::size_t stops);
std::string section_line(long revolution, double time_s, const TraceState& state);

/// t_s, stop, from, to: the changes of contact mode.
std::string events_header();
std::string event_line(double time_s, const integrate::ModeSwitch& change);

/// order, frequency_hz, amplitude_m, from the most negative order upwards; a frequency has the sign of its
/// order. No lines below the header for a spectrum without any.
std::string spectrum_csv(const response::FullSpectrum& spectrum, double speed_hz);

}  // namespace rubsweep::report
