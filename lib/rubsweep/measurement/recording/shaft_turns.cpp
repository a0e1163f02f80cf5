#include "rubsweep/measurement/recording/shaft_turns.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/findings.hpp"
#include "rubsweep/measurement/recording/speed_column.hpp"

namespace rubsweep::recording {
namespace {

/// Margin at both ends of the signal's range: samples inside a margin belong to a level, all others to an
/// edge.
constexpr double level_share = 0.1;
constexpr double half_resolved = 0.2;

/// Values of the four cubic B-splines with unit knot distance at a place 0 <= u <= 1 between two knots.
std::array<double, 4> cubic_splines(double u) {
  const double v = 1 - u;
  return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6,
          u * u * u / 6};
}

using Base = Eigen::SparseMatrix<double>;

/// Values of the Legendre polynomials up to a degree at equidistant places.
Base polynomials(Eigen::Index count, int degree) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double x = 2 * static_cast<double>(k) / static_cast<double>(count - 1) - 1;
    for (int i = 0; i <= degree; ++i)
      entries.emplace_back(static_cast<int>(k), i, std::legendre(static_cast<unsigned>(i), x));
  }
  Base base(count, degree + 1);
  base.setFromTriplets(entries.begin(), entries.end());
  return base;
}

/// Values of the cubic B-splines on `pieces` equal pieces at equidistant places.
Base splines(Eigen::Index count, Eigen::Index pieces) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double place = static_cast<double>(k * pieces) / static_cast<double>(count - 1);
    const Eigen::Index piece = std::min(static_cast<Eigen::Index>(place), pieces - 1);
    const auto values = cubic_splines(place - static_cast<double>(piece));
    for (Eigen::Index i = 0; i < 4; ++i)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(piece + i),
                           values[static_cast<std::size_t>(i)]);
  }
  Base base(count, pieces + 3);
  base.setFromTriplets(entries.begin(), entries.end());
  return base;
}

/// Values of a smooth curve whose largest distance from the given values is at most `bound`, if one is found:
/// least squares with weights that grow where the distance is large (C. L. Lawson 1961). Sampling errors are
/// bounded and not normal, and the bounds of many marks determine a smooth curve much better than their mean
/// square does.
std::optional<Eigen::VectorXd> within(const Base& base, const Eigen::VectorXd& values, double bound) {
  constexpr int most_rounds = 80;
  constexpr double hopeless = 4;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(values.size()), best;
  double smallest = hopeless * bound;
  for (int round = 0; round < most_rounds; ++round) {
    const Base weighted = weights.asDiagonal() * base;
    const Eigen::SimplicialLDLT<Base> normal(base.transpose() * weighted);
    const Eigen::VectorXd fit = base * normal.solve(weighted.transpose() * values);
    const Eigen::VectorXd left = (values - fit).cwiseAbs();
    const double largest = left.maxCoeff();
    if (round == 0 && !(largest < smallest)) return std::nullopt;
    if (largest < smallest) {
      smallest = largest;
      best = fit;
    }
    weights = (weights.array() * left.array() + 1e-12 * bound).matrix();
    weights *= static_cast<double>(values.size()) / weights.sum();
  }
  if (smallest > bound) return std::nullopt;
  return best;
}

/// Lagrange polynomial through up to `most` values next to `place`, which is an index from 0 on.
double between(std::span<const double> values, double place, std::ptrdiff_t most) {
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  const std::ptrdiff_t count = std::min(most, size);
  const std::ptrdiff_t first = std::clamp(static_cast<std::ptrdiff_t>(std::floor(place)) - count / 2 + 1,
                                          std::ptrdiff_t{0}, size - count);
  double sum = 0;
  for (std::ptrdiff_t i = first; i < first + count; ++i) {
    double weight = 1;
    for (std::ptrdiff_t j = first; j < first + count; ++j) {
      if (j != i) weight *= (place - static_cast<double>(j)) / static_cast<double>(i - j);
    }
    sum += weight * values[static_cast<std::size_t>(i)];
  }
  return sum;
}

void refuse_threshold_outside(std::span<const double> signal, double threshold) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : signal) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  if (threshold > low && threshold < high) return;
  throw ConfigError(
      fmt::format("keyphasor.threshold: is {:.4g}, allowed: between {:.4g} and {:.4g}, the signal's "
                  "lowest and highest value",
                  threshold, low, high));
}

}  // namespace

double mark_resolution(std::span<const double> signal, Mark mark, double threshold) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : signal) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  const double margin = level_share * (high - low);
  const auto on_edge = [&](double value) { return value > low + margin && value < high - margin; };
  std::array<std::size_t, 3> edges{};
  for (std::size_t k = 1; k < signal.size(); ++k) {
    const bool before = signal[k - 1] > threshold, now = signal[k] > threshold;
    if (before == now || now != (mark == Mark::bright)) continue;
    ++edges[static_cast<std::size_t>(on_edge(signal[k - 1])) + static_cast<std::size_t>(on_edge(signal[k]))];
  }
  // The median of the resolutions of all edges decides.
  const std::size_t half = (edges[0] + edges[1] + edges[2]) / 2;
  if (edges[0] > half) return 1;
  return edges[0] + edges[1] > half ? half_resolved : 0;
}

SmoothMarks smoothed_marks(std::span<const double> marks_s, double resolution_s) {
  const auto count = static_cast<Eigen::Index>(marks_s.size());
  SmoothMarks smooth{.t_s = {marks_s.begin(), marks_s.end()}};
  if (resolution_s == 0) return smooth;
  // Marks are counted from the first one in units of their resolution; so long recordings keep their digits.
  const Eigen::VectorXd marks =
      (Eigen::Map<const Eigen::VectorXd>(marks_s.data(), count).array() - marks_s.front()) / resolution_s;
  // The first curve within the bounds may touch them everywhere; the next, more flexible one is more
  // accurate.
  std::optional<Eigen::VectorXd> fit;
  bool held = false;
  const auto take = [&](const Base& base) {
    held = fit.has_value();
    if (auto next = within(base, marks, smoothing_bound)) {
      fit = std::move(next);
      smooth.degree = static_cast<int>(base.cols()) - 1;
    }
  };
  for (int degree = 1; degree <= 5 && count >= 4 * degree && !(fit && held); ++degree)
    take(polynomials(count, degree));
  constexpr Eigen::Index marks_a_piece = 4;
  for (Eigen::Index pieces = 2; count >= marks_a_piece * pieces && !(fit && held); pieces *= 2)
    take(splines(count, pieces));
  if (!fit) return smooth;
  for (Eigen::Index k = 0; k < count; ++k)
    smooth.t_s[static_cast<std::size_t>(k)] = marks_s.front() + resolution_s * (*fit)(k);
  return smooth;
}

std::vector<double> steady_turns_s(double from_s, double to_s, double speed_hz) {
  std::vector<double> begins_s;
  const auto turns = static_cast<long>(std::floor((to_s - from_s) * speed_hz * (1 + 1e-12)));
  for (long turn = 0; turn <= turns; ++turn)
    begins_s.push_back(std::min(to_s, from_s + static_cast<double>(turn) / speed_hz));
  return begins_s;
}

std::vector<double> turn_speeds_hz(std::span<const double> turn_begin_s) {
  std::vector<double> speeds_hz;
  for (std::size_t k = 1; k < turn_begin_s.size(); ++k)
    speeds_hz.push_back(1 / (turn_begin_s[k] - turn_begin_s[k - 1]));
  return speeds_hz;
}

std::vector<double> at_equal_angles(std::span<const double> signal, double first_s, double sampling_rate_hz,
                                    std::span<const double> turn_begin_s, int samples_per_revolution) {
  constexpr std::ptrdiff_t marks = 4, neighbours = 6;
  std::vector<double> samples;
  for (std::size_t turn = 0; turn + 1 < turn_begin_s.size(); ++turn) {
    for (int k = 0; k < samples_per_revolution; ++k) {
      const double turns = static_cast<double>(turn) + static_cast<double>(k) / samples_per_revolution;
      const double t_s = between(turn_begin_s, turns, marks);
      samples.push_back(between(signal, (t_s - first_s) * sampling_rate_hz, neighbours));
    }
  }
  return samples;
}

ShaftTurns turns_of(const Channels& channels, const Instrument& instrument, const SampleClock& clock,
                    const std::string& name, std::vector<std::string>& findings) {
  const std::size_t count = channels.rows();
  const double last_s = clock.first_s + static_cast<double>(count - 1) / clock.rate_hz;
  if (instrument.speed) return {.begin_s = turns_by_speed(channels, *instrument.speed, clock, name)};
  if (!instrument.keyphasor && *instrument.speed_hz > clock.rate_hz / 2)
    throw ConfigError(
        name + ": has fewer than two readings a turn at speed_hz, allowed: up to half the sampling rate");
  if (!instrument.keyphasor)
    return {.begin_s = steady_turns_s(clock.first_s, last_s, instrument.speed_hz.value())};
  const Keyphasor& keyphasor = *instrument.keyphasor;
  const Channel& channel = find_channel(channels, keyphasor.column, name);
  std::vector<double> t_s(count);
  for (std::size_t k = 0; k < count; ++k) t_s[k] = clock.first_s + static_cast<double>(k) / clock.rate_hz;
  try {
    const double threshold = keyphasor.threshold ? *keyphasor.threshold : middle_threshold(channel.values);
    refuse_threshold_outside(channel.values, threshold);
    const TurnMarks marks =
        numbered_marks(mark_times_s(t_s, channel.values, keyphasor.mark, threshold, keyphasor.hysteresis),
                       1 / clock.rate_hz);
    add_mark_findings(marks, keyphasor, findings);
    const double resolution_s = mark_resolution(channel.values, keyphasor.mark, threshold) / clock.rate_hz;
    std::vector<double> begins_s;
    for (std::size_t k = 0; k < marks.t_s.size(); k += static_cast<std::size_t>(keyphasor.pulses_per_turn))
      begins_s.push_back(marks.t_s[k]);
    SmoothMarks smooth = smoothed_marks(begins_s, resolution_s);
    return {std::move(smooth.t_s), std::move(begins_s), smoothing_bound * resolution_s, smooth.degree};
  } catch (const ConfigError& error) {
    throw ConfigError(fmt::format("{}: '{}': {}", name, channel.name, error.what()));
  }
}

AngleDoubt doubt_without_marks(std::size_t turns, double least_turns) {
  constexpr double usual_turns = 0.1;
  const double room_turns = std::max(usual_turns, least_turns);
  constexpr std::size_t most_degree = 3, turns_a_degree = 8;
  const std::size_t degree = std::min(most_degree, turns / turns_a_degree);
  if (degree == 0) return {};
  return {std::vector<double>(turns + 1, -room_turns), std::vector<double>(turns + 1, room_turns),
          static_cast<int>(degree)};
}

AngleDoubt angle_doubt_of(std::span<const double> turn_begin_s, const ShaftTurns& all) {
  AngleDoubt doubt{.degree = all.degree};
  if (all.degree == 0) return doubt;
  const auto first = static_cast<std::size_t>(std::ranges::lower_bound(all.begin_s, turn_begin_s.front()) -
                                              all.begin_s.begin());
  const double speed_hz =
      static_cast<double>(turn_begin_s.size() - 1) / (turn_begin_s.back() - turn_begin_s.front());
  for (std::size_t k = 0; k < turn_begin_s.size(); ++k) {
    const double off_s = all.mark_s[first + k] - turn_begin_s[k];
    doubt.low_turns.push_back(std::min((off_s - all.room_s) * speed_hz, 0.0));
    doubt.high_turns.push_back(std::max((off_s + all.room_s) * speed_hz, 0.0));
  }
  return doubt;
}

}  // namespace rubsweep::recording
