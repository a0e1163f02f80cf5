#include "rubsweep/ring/onsets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

namespace rubsweep::ring {
namespace {

using Complex = std::complex<double>;

/// Modes of the `count` eigenvalues nearest to `root` at the last tracked point before the speed, or the
/// first after it; those with Im < 0 aside.
std::vector<std::string> modes_at(const Track& track, double speed, Complex root, std::size_t count,
                                  bool before) {
  if (track.points.empty()) return {};
  auto point = std::partition_point(track.points.begin(), track.points.end(),
                                    [&](const TrackPoint& p) { return p.speed_rad_per_s <= speed; });
  if (point == track.points.end() || (before && point != track.points.begin())) --point;
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (Eigen::Index i = 0; i < point->spectrum.values.size(); ++i) {
    const Complex value = point->spectrum.values(i);
    if (value.imag() >= 0) by_distance.emplace_back(std::abs(value - root), static_cast<std::size_t>(i));
  }
  std::sort(by_distance.begin(), by_distance.end());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(count, by_distance.size()); ++i) {
    std::string name = describe_mode(track, *point, by_distance[i].second);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

std::vector<double> frequencies(const Eigen::VectorXcd& values) {
  std::vector<double> result;
  for (const Complex& value : values) {
    if (value.imag() > 0) result.push_back(value.imag());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Frequencies of a point where every root is neutral and none is real; empty elsewhere.
std::vector<double> neutral_frequencies(const Eigen::VectorXcd& values) {
  const double size = size_of(values);
  for (const Complex& value : values) {
    if (std::abs(value.real()) > 1e-7 * size || std::abs(value.imag()) < 1e-7 * size) return {};
  }
  return frequencies(values);
}

/// How fast the gap between frequencies k and k + 1 (ascending) opens with the speed.
double opening_rate(const NormalForm& form, std::size_t k, double speed) {
  const Spectrum s = spectrum(form, speed);
  std::vector<std::pair<double, double>> frequency_and_slope;
  for (Eigen::Index i = 0; i < s.values.size(); ++i) {
    if (s.values(i).imag() > 0) frequency_and_slope.emplace_back(s.values(i).imag(), s.slopes(i).imag());
  }
  if (frequency_and_slope.size() < k + 2) return 0;
  std::sort(frequency_and_slope.begin(), frequency_and_slope.end());
  return frequency_and_slope[k + 1].second - frequency_and_slope[k].second;
}

/// Where that rate is zero; empty when it does not change sign in the bracket.
std::optional<double> closest_approach(const NormalForm& form, std::size_t k, double low, double high) {
  const auto rate = [&](double speed) { return opening_rate(form, k, speed); };
  const double at_low = rate(low), at_high = rate(high);
  if (!(at_low < 0 && at_high > 0)) return std::nullopt;
  std::uintmax_t steps = 400;  // four halve the bracket at least: it ends before
  const auto [from, to] = boost::math::tools::toms748_solve(
      rate, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(48), steps);
  return from + 0.5 * (to - from);
}

}  // namespace

std::vector<Onset> describe_change(const Change& change, const Track& track, bool has_friction) {
  const int growing = change.after.growing_real - change.before.growing_real;
  const int decaying = change.after.decaying_real - change.before.decaying_real;
  const int pairs = change.after.growing_pairs - change.before.growing_pairs;
  const double speed = change.speed_rad_per_s;
  const std::string where = std::abs(change.root.imag()) > 0
                                ? fmt::format("at {:.6g} rad/s", change.root.imag())
                                : fmt::format("at {:.6g} 1/s", change.root.real());
  std::vector<Onset> onsets;
  const auto add = [&](const char* kind, std::size_t modes, bool before, const std::string& note) {
    onsets.push_back({kind, speed, modes_at(track, speed, change.root, modes, before), note});
  };
  if (growing == -2 && pairs == 1) {
    add("real_merger", 2, true, "growing, divergence turns into flutter, " + where);
  } else if (growing == 2 && pairs == -1) {
    add("real_split", 2, false, "growing, flutter turns into divergence, " + where);
  } else if (growing == 0 && pairs == 0 && decaying > 0) {
    add("real_split", 2, false, "decaying, " + where);
  } else if (growing == 0 && pairs == 0 && decaying < 0) {
    add("real_merger", 2, true, "decaying, " + where);
  } else {
    // The first growing root begins a divergence, the last one ends it; others only change their number.
    const std::string roots = fmt::format("growing real roots from {} to {}", change.before.growing_real,
                                          change.after.growing_real);
    const bool plain = change.before.growing_real + change.after.growing_real == 1;
    if (growing > 0) add("divergence_begin", 1, false, plain ? "" : roots);
    if (growing < 0) add("divergence_end", 1, true, plain ? "" : roots);
    const std::string note = where + (std::abs(pairs) > 1 ? fmt::format(", {} pairs", std::abs(pairs)) : "");
    if (!has_friction) {
      if (pairs > 0) add("coupling_begin", 2, true, note);
      if (pairs < 0) add("coupling_end", 2, false, note);
    } else {
      if (pairs > 0) add("flutter_begin", 1, false, speed == 0 ? "as soon as it turns" : note);
      if (pairs < 0) add("flutter_end", 1, true, note);
    }
  }
  return onsets;
}

std::vector<Onset> veerings(const Track& track, const NormalForm& form) {
  std::vector<Onset> onsets;
  std::vector<std::vector<double>> all;
  for (const TrackPoint& point : track.points) all.push_back(neutral_frequencies(point.spectrum.values));
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    if (all[i - 1].empty() || all[i].empty() || all[i + 1].empty()) continue;
    for (std::size_t k = 0; k + 1 < all[i].size(); ++k) {
      const auto gap_at = [k](const std::vector<double>& f) { return f[k + 1] - f[k]; };
      const double gap_here = gap_at(all[i]);
      if (!(gap_here < gap_at(all[i - 1]) && gap_here <= gap_at(all[i + 1]))) continue;
      const auto speed =
          closest_approach(form, k, track.points[i - 1].speed_rad_per_s, track.points[i + 1].speed_rad_per_s);
      if (!speed) continue;
      const auto f = neutral_frequencies(eigenvalues(form, *speed));
      if (f.empty()) continue;
      const double least = gap_at(f), mean = 0.5 * (f[k] + f[k + 1]);
      // Below: modes that do not know each other and cross.
      if (!(least < 0.25 * mean && least > 1e-6 * mean)) continue;
      onsets.push_back({"veering", *speed, modes_at(track, *speed, {0, mean}, 2, false),
                        fmt::format("gap {:.6g} rad/s at {:.6g} rad/s", least, mean)});
    }
  }
  return onsets;
}

}  // namespace rubsweep::ring
