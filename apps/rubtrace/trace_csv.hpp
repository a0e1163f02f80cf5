#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/trace/probe.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::apps {

/// Summary of a trace for a terminal: peaks, hits, the largest lines and the effort. `clearance_m` is the
/// clearance of the kicked stop. Without `shown`, lines are in m and peaks in clearances.
std::string trace_summary(const trace::Trace& trace, const trace::TraceWindow& window, double clearance_m,
                          const model::ShownLengths& shown = {});

/// The `count` largest lines without 0X, the largest first. A line must be above both neighbours, so that a
/// line which an incomplete period spreads over several counts once. A line must also be significant: at
/// least 1e-3 of the largest line and 1e-6 of the clearance.
std::vector<response::spectrum::SpectralLine> largest_lines(const response::spectrum::FullSpectrum& spectrum,
                                                            std::size_t count, double clearance_m);

/// One line of text on the period that a pair of probes finds. `probes` must have all probes of the run.
std::string probe_summary(const trace::ProbePeriod& period, const trace::ProbePair& pair,
                          const trace::Probes& probes, const model::ShownLengths& shown = {});

/// Tables of one traced run. Stops count from 0, as in the configuration. Times are in seconds since the
/// start of the kick.

/// Columns t_s, x_m, y_m, vx_m_per_s, vy_m_per_s, then per stop casing_i_x_m, casing_i_y_m, gap_i_m,
/// normal_force_i_n, friction_force_i_n; with torsion twist_deg, torque_nm; per stop casing_i_vx_m_per_s,
/// casing_i_vy_m_per_s; of a rotor kit coordinate_k_m, coordinate_k_m_per_s; then energies and powers as in
/// Energy.
std::string trajectory_csv(const trace::Trace& trace);

/// Columns revolution, t_s, x_m, y_m, vx_m_per_s, vy_m_per_s, then per stop casing_i_x_m, casing_i_y_m, then
/// per
/// stop casing_i_vx_m_per_s, casing_i_vy_m_per_s.
std::string section_csv(const trace::Trace& trace);

std::string events_csv(
    const trace::Trace& trace);  ///< Changes of contact mode, with columns t_s, stop, from, to.

/// Columns `order`, `frequency_hz` and `amplitude_m`, a row for each line, from the most negative order
/// upwards. The frequency has the sign of the order. An empty spectrum gives only the header.
std::string spectrum_csv(const response::spectrum::FullSpectrum& spectrum, double speed_hz);

}  // namespace rubsweep::apps
