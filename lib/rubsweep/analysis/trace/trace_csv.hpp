#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/trace/probe.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::trace {

/// Summary of a trace for a terminal: peaks, hits, the largest lines and the effort.
/// `clearance_m` is that of the kicked stop. Lengths as asked for, lines in m otherwise and peaks in
/// clearances alone.
std::string trace_summary(const Trace& trace, const TraceWindow& window, double clearance_m,
                          const model::ShownLengths& shown = {});

/// The `count` largest lines but 0X, largest first; only those above both neighbours (one line spread over
/// several by an incomplete period is one line) and above the floor of significance (1e-3 of the largest,
/// 1e-6 of the clearance).
std::vector<response::spectrum::SpectralLine> largest_lines(const response::spectrum::FullSpectrum& spectrum,
                                                            std::size_t count, double clearance_m);

/// Verdict of a pair of probes on the same run, one line. `angle_deg`: of all probes.
std::string probe_summary(const ProbePeriod& period, const ProbePair& pair, const Probes& probes,
                          const model::ShownLengths& shown = {});

/// The tables of one traced run. Stops count from 0, as in the configuration. Times are seconds since the
/// start of the kick.

/// t_s, x_m, y_m, vx_m_per_s, vy_m_per_s, then per stop casing_i_x_m, casing_i_y_m, gap_i_m,
/// normal_force_i_n, friction_force_i_n; with torsion twist_deg, torque_nm; per stop casing_i_vx_m_per_s,
/// casing_i_vy_m_per_s; of a rotor kit coordinate_k_m, coordinate_k_m_per_s; then energies and powers as in
/// Energy.
std::string trajectory_csv(const Trace& trace);

/// revolution, t_s, x_m, y_m, vx_m_per_s, vy_m_per_s, then per stop casing_i_x_m, casing_i_y_m, then per
/// stop casing_i_vx_m_per_s, casing_i_vy_m_per_s.
std::string section_csv(const Trace& trace);

/// t_s, stop, from, to: the changes of contact mode.
std::string events_csv(const Trace& trace);

/// order, frequency_hz, amplitude_m, from the most negative order upwards; a frequency has the sign of its
/// order. No lines below the header for a spectrum without any.
std::string spectrum_csv(const response::spectrum::FullSpectrum& spectrum, double speed_hz);

}  // namespace rubsweep::trace
