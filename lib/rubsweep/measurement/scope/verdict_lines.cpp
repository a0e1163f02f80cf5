#include "rubsweep/measurement/scope/verdict_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/core/response/spectrum/resolved_lines.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;

/// Amplitude that the lines between the bins leave, at most, in a bin where none of them stands.
double leak_at(const Verdict& verdict, double order) {
  double leak = 0;
  for (const DiscreteLine& line : verdict.discrete_lines) {
    const double bins = std::abs(order - line.order) * verdict.turns;
    // A line at so many bins of a window without weights.
    leak += line.amplitude_m * std::abs(std::sin(std::numbers::pi * bins)) / (std::numbers::pi * bins);
  }
  return leak;
}

}  // namespace

double most_order_looked_at(const Reading& reading) {
  constexpr double flat_share = 0.4;
  return std::min(most_order, flat_share * reading.readings_per_turn);
}

double Reading::missed_share(double order) const {
  return std::min(1.0, 0.005 * std::pow(2 * std::numbers::pi * std::abs(order) / readings_per_turn, 6));
}

const DiscreteLine* line_of_bin(const Verdict& verdict, double order) {
  for (const DiscreteLine& line : verdict.discrete_lines)
    if (std::lround(line.order * verdict.turns) == std::lround(order * verdict.turns)) return &line;
  return nullptr;
}

std::vector<DiscreteLine> discrete_lines_of(std::span<const Complex> samples,
                                            std::size_t samples_per_revolution, const Reading& reading,
                                            const Verdict& verdict,
                                            response::spectrum::SpectrumWorkspace& workspace) {
  constexpr std::size_t most_turns = 128;
  const std::size_t turns = std::min(samples.size() / samples_per_revolution, most_turns);
  const auto per_turn = static_cast<double>(samples_per_revolution);
  const double highest = most_order_looked_at(reading) / per_turn;
  const auto found = response::spectrum::resolve_lines(samples.last(turns * samples_per_revolution),
                                                       {.most_lines = most_discrete_lines,
                                                        .least_amplitude = verdict.visible_m,
                                                        .lowest = -highest,
                                                        .highest = highest},
                                                       workspace);
  std::vector<DiscreteLine> lines;
  for (const response::spectrum::ResolvedLine& line : found) {
    const double order = line.frequency * per_turn, size = std::abs(line.amplitude);
    lines.push_back(
        {order, line.frequency_uncertainty * per_turn, size,
         std::hypot(line.amplitude_uncertainty, reading.missed_share(order) * size),
         // At the begin of the turns that the orbit has.
         std::arg(line.amplitude) +
             2 * std::numbers::pi * order *
                 static_cast<double>(turns - std::min(turns, std::size_t{most_aperiodic_turns}))});
  }
  return lines;
}

void add_uncertainties(const Reading& reading, Verdict& verdict) {
  for (MeasuredLine& line : verdict.lines) {
    const double size = std::abs(line.amplitude_m);
    double method = reading.missed_share(line.order) * size;
    if (!verdict.period && line.order != 0) {
      const DiscreteLine* own = line_of_bin(verdict, line.order);
      const Complex true_m = own ? std::polar(own->amplitude_m, own->phase_rad) : Complex();
      method = std::hypot(method, own ? std::abs(line.amplitude_m - true_m) : leak_at(verdict, line.order));
    }
    line.uncertainty_m = std::hypot(verdict.noise_m, method);
  }
}

}  // namespace rubsweep::scope
