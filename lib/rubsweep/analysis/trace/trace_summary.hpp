#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/trace/probe_period.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/core/response/motion/motion.hpp"

namespace rubsweep::trace {

/// Summary of a trace for a terminal: peaks, hits, the largest lines and the effort.
/// `clearance_m` is that of the kicked stop. Lengths as asked for, lines in m otherwise and peaks in clearances alone.
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

}  // namespace rubsweep::trace
