#include "rubsweep/measurement/scope/verdict_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "rubsweep/core/response/spectrum/resolved_lines.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;

/// Largest leakage of the lines between the bins into a bin that has no line of its own.
double leak_at(const Verdict& verdict, double order) {
  double leak = 0;
  for (const DiscreteLine& line : verdict.discrete_lines) {
    const double bins = std::abs(order - line.order) * verdict.turns;
    // Leakage of the line at a distance of `bins` bins, without a window function.
    leak += line.amplitude_m * std::abs(std::sin(std::numbers::pi * bins)) / (std::numbers::pi * bins);
  }
  return leak;
}

/// Scale factor for the orders of lines, because the recording's angles may be wrong.
struct Scale {
  double factor = 1, uncertainty = 0;
};

/// Scale from the line locked to the shaft, if the marks permit it; otherwise 1, with the marks' uncertainty.
Scale scale_of(std::span<const response::spectrum::ResolvedLine> lines, double per_turn, std::size_t turns,
               const recording::AngleDoubt& doubt) {
  // Noise of the keyphasor shifts even those marks that have readings on their edges.
  constexpr double most_noise_turns = 0.02;
  double room = 0;
  for (std::size_t k = 0; k < doubt.low_turns.size(); ++k)
    room = std::max(room, (doubt.high_turns[k] - doubt.low_turns[k]) / static_cast<double>(turns));
  const double within = std::max(room, most_noise_turns / static_cast<double>(turns));
  for (const response::spectrum::ResolvedLine& line : lines)
    if (const double order = std::abs(line.frequency) * per_turn; std::abs(order - 1) <= within)
      return {1 / order, line.frequency_uncertainty * per_turn};
  return {1, room / std::sqrt(12.0)};
}

/// Half of the share of its amplitude that a line of order 1 loses by angles at the ends of their intervals;
/// for other lines it grows with the square of the order.
double blurred_share(const recording::AngleDoubt& doubt) {
  double squares = 0;
  for (std::size_t k = 0; k < doubt.low_turns.size(); ++k)
    squares += std::pow(2 * std::numbers::pi * (doubt.high_turns[k] - doubt.low_turns[k]), 2);
  return squares / (16 * static_cast<double>(std::max(doubt.low_turns.size(), std::size_t{1})));
}

/// Width of a bin, in orders.
double bin_of(std::size_t turns) { return 1 / static_cast<double>(std::min(turns, most_resolved_turns)); }

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
                                            LeastLine least,
                                            response::spectrum::SpectrumWorkspace& workspace) {
  const std::size_t turns = std::min(samples.size() / samples_per_revolution, most_resolved_turns);
  const auto per_turn = static_cast<double>(samples_per_revolution);
  const double highest = most_order_looked_at(reading) / per_turn;
  const auto found = response::spectrum::resolve_lines(
      samples.last(turns * samples_per_revolution),
      {.most_lines = most_discrete_lines,
       .least_amplitude =
           reading.integration.times == 0 ? std::max(least.seen_m, least.floor_m) : least.seen_m,
       .lowest = -highest,
       .highest = highest},
      workspace);
  const Scale scale = scale_of(found, per_turn, turns, reading.angle_doubt);
  const double blurred = blurred_share(reading.angle_doubt);
  std::vector<DiscreteLine> lines;
  for (const response::spectrum::ResolvedLine& line : found) {
    const double order = scale.factor * line.frequency * per_turn;
    // The line of the displacement, of one that was measured as a derivative.
    const double integrated = reading.integration.noise_at(order),
                 size = integrated * std::abs(line.amplitude);
    if (std::abs(order) < reading.integration.lowest_order || size < least.floor_m) continue;
    lines.push_back(
        {order, std::hypot(line.frequency_uncertainty * per_turn, order * scale.uncertainty), size,
         std::hypot(integrated * line.amplitude_uncertainty, reading.missed_share(order) * size,
                    std::min(1.0, blurred * order * order) * size),
         // Phase at the beginning of the turns that the orbit shows.
         std::arg(line.amplitude) - std::copysign(reading.integration.times * std::numbers::pi / 2, order) +
             2 * std::numbers::pi * order *
                 static_cast<double>(turns - std::min(turns, std::size_t{most_aperiodic_turns}))});
  }
  if (reading.integration.times > 0)
    std::ranges::stable_sort(lines, std::greater{}, &DiscreteLine::amplitude_m);
  return lines;
}

std::optional<double> room_of_period(std::span<const Complex> samples, std::size_t samples_per_revolution,
                                     const Reading& reading, int period, LeastLine least,
                                     response::spectrum::SpectrumWorkspace& workspace) {
  constexpr double hann_noise = 1.23;  // noise of a line under a Hann window / without a window
  const auto lines = discrete_lines_of(samples, samples_per_revolution, reading,
                                       {hann_noise * least.seen_m, hann_noise * least.floor_m}, workspace);
  // Limits up to which the lines of a motion locked to the shaft may rotate relative to it during the
  // recording.
  constexpr double most_deviations = 2, most_turned = 0.02;
  const double bin = bin_of(samples.size() / samples_per_revolution);
  const auto nearest = [&](const DiscreteLine& line) { return std::lround(line.order * period); };
  // A line within a bin is at most half a bin away from the multiple.
  double room = bin / 2;
  for (const DiscreteLine& line : lines) {
    const double off = std::abs(line.order - static_cast<double>(nearest(line)) / period);
    if (nearest(line) % period == 0 || off > bin) continue;
    // Smaller lines near the same multiple are sidebands of a modulated line.
    if (std::ranges::any_of(lines, [&](const DiscreteLine& larger) {
          return nearest(larger) == nearest(line) && larger.amplitude_m > line.amplitude_m;
        }))
      continue;
    const double doubt = most_deviations * line.order_uncertainty;
    if (off > doubt + most_turned * bin) return std::nullopt;
    // A multiple that a shorter period has, too, says nothing about this period.
    if (std::gcd(nearest(line), static_cast<long>(period)) == 1) room = std::min(room, off + doubt);
  }
  return room;
}

bool may_be_torus(const Verdict& verdict) {
  constexpr double most_turned = 0.1;
  return verdict.order_room.value_or(0) > most_turned * bin_of(static_cast<std::size_t>(verdict.turns));
}

void add_uncertainties(const Reading& reading, Verdict& verdict) {
  for (MeasuredLine& line : verdict.lines) {
    const double size = std::abs(line.amplitude_m);
    double method = reading.missed_share(line.order) * size;
    // A mean of periods loses 1 - sin(x) / x of a line that turns by 2 x relative to it.
    const double turned_rad = std::numbers::pi * verdict.order_room.value_or(0) * verdict.turns;
    if (line.order != std::round(line.order)) method = std::hypot(method, size * turned_rad * turned_rad / 6);
    if (!verdict.period && line.order != 0) {
      const DiscreteLine* own = line_of_bin(verdict, line.order);
      const Complex true_m = own ? std::polar(own->amplitude_m, own->phase_rad) : Complex();
      method = std::hypot(method, own ? std::abs(line.amplitude_m - true_m) : leak_at(verdict, line.order));
    }
    line.uncertainty_m = std::hypot(verdict.noise_at(line.order), method);
  }
}

}  // namespace rubsweep::scope
