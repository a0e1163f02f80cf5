#include "rubsweep/analysis/trace/trace_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/response/motion/classify.hpp"

namespace rubsweep::trace {
namespace {

using model::LengthUnit;
using response::spectrum::SpectralLine;

std::string peaks(const response::motion::ContactFacts& facts, double clearance_m, const model::ShownLengths& shown) {
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

}  // namespace

std::string trace_summary(const Trace& trace, const TraceWindow& window, double clearance_m,
                          const model::ShownLengths& shown) {
  const std::string run =
      fmt::format("run       {} revolutions, {}\n", trace.revolutions,
                  trace.last_contact_revolution
                      ? fmt::format("last contact in revolution {}", *trace.last_contact_revolution)
                      : "no contact");
  if (window.turns == 0) return run;
  const response::motion::ContactFacts whole = facts_of_last(trace, trace.turns.size());
  return run + fmt::format(
                   "peak      {}; {} in the last {} revolutions\n"
                   "contact   {:.4g} hits per revolution, {:.3g} % of the time, in the last {} revolutions\n"
                   "lines     {}\n"
                   "effort    {}\n",
                   peaks(whole, clearance_m, shown), peaks(window.contact, clearance_m, shown), window.turns,
                   static_cast<double>(window.contact.hits) / window.turns, 100 * window.contact.contact_fraction,
                   window.turns, lines_text(largest_lines(window.spectrum, 5, clearance_m), shown),
                   effort_text(trace.effort, trace.revolutions));
}

std::string probe_summary(const ProbePeriod& period, const ProbePair& pair, const Probes& probes,
                          const model::ShownLengths& shown) {
  const std::string what = period.period
                               ? *period.period == 1 ? std::string("repeats every turn")
                                                     : fmt::format("repeats after {} turns", *period.period)
                               : std::string("repeats after none of the numbers of turns looked for");
  return fmt::format(
      "probes    {} by {} readings of sensors {} ({:g} deg) and {} ({:g} deg) every {:g} s, noise {}: "
      "{:.2g} % of the energy off the lines, {:.2g} % allowed\n",
      what, period.readings, pair.first, probes.angle_deg[pair.first], pair.second, probes.angle_deg[pair.second],
      probes.sample_s, model::length_text(probes.noise_m, shown, LengthUnit::m, 6), 100 * period.unexplained_share,
      100 * period.allowed_share);
}

std::vector<SpectralLine> largest_lines(const response::spectrum::FullSpectrum& spectrum, std::size_t count,
                                        double clearance_m) {
  const int first = spectrum.first_line(), last = spectrum.last_line();
  const auto amplitude = [&](int k) { return k < first || k > last || k == 0 ? 0.0 : spectrum.amplitude(k); };
  std::vector<SpectralLine> lines;
  for (int k = first; k <= last; ++k) {
    // On a plateau of two equal lines the first is the one.
    if (amplitude(k) > amplitude(k - 1) && amplitude(k) >= amplitude(k + 1)) {
      lines.push_back({spectrum.order(k), amplitude(k)});
    }
  }
  std::stable_sort(lines.begin(), lines.end(), [](const SpectralLine& a, const SpectralLine& b) {
    return a.amplitude_m > b.amplitude_m;
  });
  if (lines.empty()) return lines;
  const double floor_m = std::max(response::motion::significant_share_of_largest * lines.front().amplitude_m,
                                  response::motion::significant_share_of_clearance * clearance_m);
  while (!lines.empty() && lines.back().amplitude_m <= floor_m) lines.pop_back();
  if (lines.size() > count) lines.resize(count);
  return lines;
}

}  // namespace rubsweep::trace
