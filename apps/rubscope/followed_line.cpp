#include "rubscope/followed_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/straight_line.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"

namespace rubsweep::apps {

using namespace recording;

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double room_at_ends = 0.25, steps_over_even = 4;
constexpr std::size_t steps_a_window = 8, finer_than_bins = 4;
constexpr std::size_t fewest_windows = 4;

/// Places of the short windows, in readings, and the frequencies that are looked at.
struct Windows {
  std::size_t length = 0, step = 0, count = 0;
  double bin_hz = 0;
  std::size_t first_bin = 0, bins = 0;
  double rate_hz = 0;

  double frequency_hz(std::size_t bin) const { return bin_hz * static_cast<double>(first_bin + bin); }
  double middle(std::size_t window) const {
    return static_cast<double>(window * step) + static_cast<double>(length) / 2;
  }
};

/// Windows so long that an even sweep passes one bin in each, and at least four turns.
std::optional<Windows> windows_of(std::size_t readings, double rate_hz, const Sweep& sweep) {
  const auto [slowest_hz, fastest_hz] = std::minmax(sweep.from_hz, sweep.to_hz);
  const double whole_s = static_cast<double>(readings) / rate_hz;
  const double even = std::max(fastest_hz - slowest_hz, 1 / whole_s) / whole_s;
  const double length_s = std::max(1 / std::sqrt(even), 4 / slowest_hz);
  Windows windows{.length = static_cast<std::size_t>(length_s * rate_hz), .rate_hz = rate_hz};
  windows.step = windows.length / steps_a_window;
  if (windows.step == 0 || readings < fewest_windows * windows.length) return std::nullopt;
  windows.count = (readings - windows.length) / windows.step + 1;
  windows.bin_hz = rate_hz / static_cast<double>(finer_than_bins * windows.length);
  windows.first_bin = static_cast<std::size_t>((1 - room_at_ends) * slowest_hz / windows.bin_hz);
  windows.bins =
      static_cast<std::size_t>((1 + room_at_ends) * fastest_hz / windows.bin_hz) + 2 - windows.first_bin;
  if (windows.first_bin + windows.bins > finer_than_bins * windows.length / 2) return std::nullopt;
  return windows;
}

double hann(std::size_t k, std::size_t length) {
  return 1 - std::cos(2 * pi * (static_cast<double>(k) + 0.5) / static_cast<double>(length));
}

double mean_of(std::span<const double> readings) {
  double sum = 0, count = 0;
  for (const double value : readings) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++count;
  }
  return sum / std::max(count, 1.0);
}

/// Logarithms of the powers of all windows at all frequencies, above the median of their window.
std::vector<std::vector<double>> spectra_of(std::span<const double> readings, const Windows& windows) {
  response::spectrum::SpectrumWorkspace workspace;
  std::vector<std::vector<double>> spectra(windows.count);
  std::vector<Complex> padded(finer_than_bins * windows.length);
  const double mean = mean_of(readings);
  for (std::size_t window = 0; window < windows.count; ++window) {
    for (std::size_t k = 0; k < windows.length; ++k) {
      const double value = readings[window * windows.step + k];
      padded[k] = std::isfinite(value) ? hann(k, windows.length) * (value - mean) : 0.0;
    }
    const auto lines = response::spectrum::transform(padded, workspace);
    std::vector<double>& powers = spectra[window];
    for (std::size_t bin = 0; bin < windows.bins; ++bin)
      powers.push_back(std::log(std::norm(lines[windows.first_bin + bin]) + 1e-300));
    std::vector<double> sorted = powers;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    for (double& power : powers) power -= *middle;
  }
  return spectra;
}

/// The path of largest sum, as a frequency index in each window.
std::vector<std::size_t> best_path(const std::vector<std::vector<double>>& spectra, const Windows& windows,
                                   const Sweep& sweep) {
  const double even_hz = std::abs(sweep.to_hz - sweep.from_hz) / static_cast<double>(windows.count);
  const double usual = std::max(steps_over_even / 2 * even_hz, windows.bin_hz) / windows.bin_hz;
  const auto farthest = static_cast<std::size_t>(std::ceil(2 * usual));
  const auto near = [&](std::size_t bin, double given_hz) {
    return std::abs(windows.frequency_hz(bin) / given_hz - 1) <= room_at_ends;
  };
  std::vector<double> best(windows.bins);
  for (std::size_t bin = 0; bin < windows.bins; ++bin)
    best[bin] = near(bin, sweep.from_hz) ? spectra[0][bin] : -INFINITY;
  std::vector<std::vector<std::size_t>> before(windows.count, std::vector<std::size_t>(windows.bins));
  for (std::size_t window = 1; window < windows.count; ++window) {
    std::vector<double> next(windows.bins, -INFINITY);
    for (std::size_t bin = 0; bin < windows.bins; ++bin) {
      const std::size_t first = bin - std::min(bin, farthest),
                        last = std::min(windows.bins - 1, bin + farthest);
      for (std::size_t from = first; from <= last; ++from) {
        const double moved = (static_cast<double>(bin) - static_cast<double>(from)) / usual;
        const double sum = best[from] - moved * moved / 2;
        if (sum > next[bin]) {
          next[bin] = sum;
          before[window][bin] = from;
        }
      }
      next[bin] += spectra[window][bin];
    }
    best = std::move(next);
  }
  for (std::size_t bin = 0; bin < windows.bins; ++bin)
    if (!near(bin, sweep.to_hz)) best[bin] = -INFINITY;
  std::vector<std::size_t> path(windows.count);
  path.back() = static_cast<std::size_t>(std::ranges::max_element(best) - best.begin());
  for (std::size_t window = windows.count - 1; window > 0; --window)
    path[window - 1] = before[window][path[window]];
  return path;
}

/// Line through the values of the windows nearest to one, as many as lie on one window's length.
numerics::StraightLine line_near(std::span<const double> values, std::size_t window) {
  constexpr std::size_t points = steps_a_window + 1;
  const std::size_t first = std::min(window - std::min(window, points / 2), values.size() - points);
  std::array<double, points> places{};
  for (std::size_t k = 0; k < points; ++k) places[k] = static_cast<double>(first + k);
  return numerics::line_through(places, values.subspan(first, points));
}

/// Value between the values at the middles of the windows; beyond them on a line through the outer ones.
double between_windows(std::span<const double> values, double place, const Windows& windows) {
  const double at = (place - windows.middle(0)) / static_cast<double>(windows.step);
  if (at < 0) return values.front() + line_near(values, 0).slope * at;
  const auto last = static_cast<double>(values.size() - 1);
  if (at > last) return values.back() + line_near(values, values.size() - 1).slope * (at - last);
  const auto first = std::min(static_cast<std::size_t>(at), values.size() - 2);
  return std::lerp(values[first], values[first + 1], at - static_cast<double>(first));
}

/// Angles of the shaft in turns at all readings along a path.
std::vector<double> angles_along(std::span<const std::size_t> path, std::size_t readings,
                                 const Windows& windows) {
  std::vector<double> coarse_hz, speeds_hz, turns{0};
  for (const std::size_t bin : path) coarse_hz.push_back(windows.frequency_hz(bin));
  for (std::size_t window = 0; window < coarse_hz.size(); ++window)
    speeds_hz.push_back(line_near(coarse_hz, window)(static_cast<double>(window)));
  for (std::size_t k = 1; k < readings; ++k)
    turns.push_back(turns.back() +
                    between_windows(speeds_hz, static_cast<double>(k) - 0.5, windows) / windows.rate_hz);
  return turns;
}

/// Phase in turns by which the readings lead these angles, in every window, unwrapped.
std::vector<double> phases_against(std::span<const double> readings, std::span<const double> turns,
                                   const Windows& windows) {
  const double mean = mean_of(readings);
  std::vector<double> phases;
  for (std::size_t window = 0; window < windows.count; ++window) {
    Complex sum = 0;
    // The middle half of the window: the speed changes less in it.
    const std::size_t length = windows.length / 2, first = window * windows.step + windows.length / 4;
    for (std::size_t k = 0; k < length; ++k)
      if (const double value = readings[first + k]; std::isfinite(value))
        sum += hann(k, length) * (value - mean) * std::polar(1.0, -2 * pi * std::fmod(turns[first + k], 1.0));
    double phase = std::arg(sum) / (2 * pi);
    if (!phases.empty()) phase += std::round(phases.back() - phase);
    phases.push_back(phase);
  }
  return phases;
}

/// Scatter of phases about the straight lines through phases of other readings.
double scatter_of(std::span<const double> phases) {
  std::vector<double> off;
  // Windows half as long as steps_a_window steps have no reading in common.
  constexpr std::size_t apart = steps_a_window / 2;
  for (std::size_t k = apart; k + apart < phases.size(); ++k)
    off.push_back(std::abs(phases[k - apart] - 2 * phases[k] + phases[k + apart]));
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::ranges::nth_element(off, middle);
  // The median of |x| is 0.674 of the standard deviation, that of a second difference the root of 6 as large.
  return *middle / (0.674 * std::sqrt(6.0));
}

}  // namespace

std::optional<FollowedTurns> follow_line(const std::vector<std::vector<double>>& probes, double first_s,
                                         double sampling_rate_hz, const Sweep& sweep) {
  constexpr double stands_out = 4;  // in powers of e: 55 times the median power
  const auto windows = windows_of(probes[0].size(), sampling_rate_hz, sweep);
  if (!windows) return std::nullopt;
  std::vector<std::size_t> path;
  double highest = 0;
  std::size_t decides = 0;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const auto spectra = spectra_of(probes[i], *windows);
    const std::vector<std::size_t> found = best_path(spectra, *windows, sweep);
    double sum = 0;
    for (std::size_t window = 0; window < windows->count; ++window)
      sum += spectra[window][found[window]] / static_cast<double>(windows->count);
    if (sum <= highest) continue;
    highest = sum;
    path = found;
    decides = i;
  }
  if (highest < stands_out) return std::nullopt;
  std::vector<double> turns = angles_along(path, probes[decides].size(), *windows);
  const std::vector<double> phases = phases_against(probes[decides], turns, *windows);
  for (std::size_t k = 0; k < turns.size(); ++k)
    turns[k] += between_windows(phases, static_cast<double>(k), *windows);
  FollowedTurns followed{.begin_s = {first_s}, .angle_uncertainty_turns = scatter_of(phases)};
  followed.speed_uncertainty_hz =
      followed.angle_uncertainty_turns * sampling_rate_hz / static_cast<double>(windows->length / 2);
  double next = turns[0] + 1;
  for (std::size_t k = 1; k < turns.size(); ++k)
    for (; turns[k] >= next; ++next) {
      const double share = std::clamp((next - turns[k - 1]) / (turns[k] - turns[k - 1]), 0.0, 1.0);
      followed.begin_s.push_back(first_s + (static_cast<double>(k - 1) + share) / sampling_rate_hz);
    }
  return followed;
}

FollowedTurns followed_turns(const Channels& channels, const Instrument& instrument,
                             const std::string& name) {
  const SampleClock clock = clock_of(channels, instrument, name);
  const auto count = static_cast<double>(channels.rows());
  const auto place = [&](std::optional<double> t_s, double otherwise) {
    const double at = t_s ? std::ceil((*t_s - clock.first_s) * clock.rate_hz - 1e-9) : otherwise;
    return static_cast<std::ptrdiff_t>(std::clamp(at, 0.0, count));
  };
  const std::ptrdiff_t first = place(instrument.from_s, 0),
                       end = std::max(first, place(instrument.to_s, count));
  std::vector<std::vector<double>> probes;
  for (const Probe& probe : instrument.probes) {
    const std::vector<double>& values = find_channel(channels, probe.column, name).values;
    probes.emplace_back(values.begin() + first, values.begin() + end);
  }
  auto turns = follow_line(probes, clock.first_s + static_cast<double>(first) / clock.rate_hz, clock.rate_hz,
                           *instrument.sweep);
  if (!turns)
    throw ConfigError(
        fmt::format("{}: sweep: no line stands out from {} to {} Hz, allowed: a line whose ends are known "
                    "to a quarter, below half the sampling rate, in a recording of many turns",
                    name, instrument.sweep->from_hz, instrument.sweep->to_hz));
  turns->finding = fmt::format(
      "the speed is that of the line followed through the sweep, known to {:.2g} Hz, angles to {:.2g} turns; "
      "its phase, "
      "also across a resonance, is not known",
      turns->speed_uncertainty_hz, turns->angle_uncertainty_turns);
  return *std::move(turns);
}

}  // namespace rubsweep::apps
