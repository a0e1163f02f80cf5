#include "rubsweep/measurement/recording/found_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/spectrum/resolved_lines.hpp"

namespace rubsweep::recording {
namespace {

using Complex = std::complex<double>;
using response::spectrum::ResolvedLine;
using std::numbers::pi;

constexpr int steps_of_a_turn = 4, smoothed_turns = 4;
constexpr double fewest_turns_searched = 12, looked_at = 0.4;

/// Readings times e^{-i 2 pi f t}, averaged under Hann windows of four turns, one value every quarter turn.
/// Missing readings are replaced by the mean.
std::vector<Complex> shifted_down(const std::vector<double>& readings, double readings_per_turn) {
  double mean = 0, count = 0;
  for (const double value : readings) {
    if (!std::isfinite(value)) continue;
    mean += value;
    ++count;
  }
  mean /= std::max(count, 1.0);
  const double half = 0.5 * smoothed_turns * readings_per_turn,
               last = static_cast<double>(readings.size() - 1);
  std::vector<Complex> smooth;
  for (double middle = half; middle + half <= last; middle += readings_per_turn / steps_of_a_turn) {
    Complex sum = 0;
    double weights = 0;
    for (auto k = static_cast<std::size_t>(std::ceil(middle - half)); static_cast<double>(k) <= middle + half;
         ++k) {
      const double place = static_cast<double>(k);
      const double weight = 1 + std::cos(pi * (place - middle) / half);
      weights += weight;
      if (std::isfinite(readings[k]))
        sum += weight * (readings[k] - mean) *
               std::polar(1.0, -2 * pi * std::fmod(place / readings_per_turn, 1.0));
    }
    smooth.push_back(sum / weights);
  }
  return smooth;
}

/// The line near a frequency.
std::optional<FoundSpeed> line_near(const std::vector<std::vector<double>>& probes, double sampling_rate_hz,
                                    double given_hz) {
  constexpr double stands_out = 10, least_share = 0.02;
  const double readings_per_turn = sampling_rate_hz / given_hz;
  double weights = 0, most_weight = 0, sum = 0, largest = 0, largest_place = 0;
  response::spectrum::SpectrumWorkspace workspace;
  for (const std::vector<double>& readings : probes) {
    if (static_cast<double>(readings.size()) < fewest_turns_searched * readings_per_turn) return std::nullopt;
    const std::vector<Complex> sequence = shifted_down(readings, readings_per_turn);
    const double size =
        std::abs(*std::ranges::max_element(sequence, {}, [](Complex z) { return std::norm(z); }));
    auto lines = response::spectrum::resolve_lines(sequence,
                                                   {.most_lines = 5,
                                                    .about_mean = false,
                                                    .least_amplitude = least_share * size,
                                                    .lowest = -looked_at / steps_of_a_turn,
                                                    .highest = looked_at / steps_of_a_turn},
                                                   workspace);
    std::erase_if(lines, [](const ResolvedLine& line) {
      return std::abs(line.amplitude) < stands_out * line.amplitude_uncertainty;
    });
    if (lines.empty()) continue;
    if (std::abs(lines.front().amplitude) > largest) {
      largest = std::abs(lines.front().amplitude);
      largest_place = lines.front().frequency * steps_of_a_turn;
    }
    const auto near = std::ranges::find_if(lines, [](const ResolvedLine& line) {
      return std::abs(line.frequency) * steps_of_a_turn <= most_speed_error;
    });
    if (near == lines.end()) continue;
    const double uncertainty = near->frequency_uncertainty * steps_of_a_turn;
    const double weight = 1 / std::max(uncertainty * uncertainty, 1e-24);
    weights += weight;
    most_weight = std::max(most_weight, weight);
    sum += weight * near->frequency * steps_of_a_turn;
  }
  if (largest == 0) return std::nullopt;
  FoundSpeed found{.largest_hz = given_hz * (1 + largest_place)};
  if (weights > 0) {
    found.speed_hz = given_hz * (1 + sum / weights);
    // Lines other than 1X disturb both probes alike, so two probes are only as accurate as the better one.
    found.uncertainty_hz = given_hz / std::sqrt(most_weight);
  }
  return found;
}

/// Speed from the lines of order 2 and 3, where both exist and give the same speed.
std::optional<FoundSpeed> speed_by_harmonics(const std::vector<std::vector<double>>& probes,
                                             double sampling_rate_hz, double given_hz) {
  constexpr double same = 4, rounding = 1e-7;
  std::vector<FoundSpeed> by_order;
  for (const double order : {2.0, 3.0}) {
    if (order * given_hz > sampling_rate_hz / 4) return std::nullopt;
    const auto found = line_near(probes, sampling_rate_hz, order * given_hz);
    if (!found || found->speed_hz == 0) return std::nullopt;
    by_order.push_back({found->speed_hz / order, found->uncertainty_hz / order, 0, true});
  }
  const double room_hz =
      same * std::hypot(by_order[0].uncertainty_hz, by_order[1].uncertainty_hz) + rounding * given_hz;
  if (std::abs(by_order[0].speed_hz - by_order[1].speed_hz) > room_hz) return std::nullopt;
  return by_order[by_order[1].uncertainty_hz < by_order[0].uncertainty_hz ? 1 : 0];
}

}  // namespace

std::optional<FoundSpeed> speed_near(const std::vector<std::vector<double>>& probes, double sampling_rate_hz,
                                     double given_hz) {
  const auto found = line_near(probes, sampling_rate_hz, given_hz);
  if (found && found->speed_hz > 0) return found;
  const auto other = speed_by_harmonics(probes, sampling_rate_hz, given_hz);
  return other ? other : found;
}

double speed_to_take(double given_hz, const std::optional<FoundSpeed>& found, double turns,
                     std::vector<std::string>& findings) {
  constexpr double small_turns = 1e-3, sure = 3;
  if (!found) return given_hz;
  if (found->speed_hz == 0) {
    findings.push_back(fmt::format(
        "speed_hz is {}, and no line stands within {} % of it; the largest one near it is at {}",
        model::speed_text(given_hz), 100 * most_speed_error, model::speed_text(found->largest_hz)));
    return given_hz;
  }
  const double off_hz = std::abs(found->speed_hz - given_hz);
  if (off_hz / given_hz * turns < small_turns || off_hz < sure * found->uncertainty_hz) return given_hz;
  findings.push_back(
      fmt::format("the speed is taken from the signal{}: {} +- {:.2g} Hz, where speed_hz says {}",
                  found->by_harmonics ? ", by its lines of order 2 and 3" : "",
                  model::speed_text(found->speed_hz, 7), found->uncertainty_hz, model::speed_text(given_hz)));
  return found->speed_hz;
}

}  // namespace rubsweep::recording
