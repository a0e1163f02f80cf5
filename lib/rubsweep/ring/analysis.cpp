#include "rubsweep/ring/analysis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace rubsweep::ring {
namespace {

using Complex = std::complex<double>;

/// Names of the modes of the `count` eigenvalues with Im >= 0 nearest to `root`, at the last tracked point
/// before the speed, or at the first one after it.
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

/// Frequencies where all eigenvalues are neutral and none is real; empty elsewhere.
std::vector<double> neutral_frequencies(const Eigen::VectorXcd& values) {
  const double size = size_of(values);
  for (const Complex& value : values) {
    if (std::abs(value.real()) > 1e-7 * size || std::abs(value.imag()) < 1e-7 * size) return {};
  }
  return frequencies(values);
}

/// Derivative by the speed of the gap between the frequencies k and k + 1, in ascending order.
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

/// Speed at which the gap between the frequencies k and k + 1 is smallest; empty unless its derivative
/// changes from negative to positive between `low` and `high`.
std::optional<double> closest_approach(const NormalForm& form, std::size_t k, double low, double high) {
  const auto rate = [&](double speed) { return opening_rate(form, k, speed); };
  const double at_low = rate(low), at_high = rate(high);
  if (!(at_low < 0 && at_high > 0)) return std::nullopt;
  std::uintmax_t steps = 400;  // never reached: four evaluations at least halve the bracket
  const auto [from, to] = boost::math::tools::toms748_solve(
      rate, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(48), steps);
  return from + 0.5 * (to - from);
}

/// Real part of the eigenvalue nearest to `place`.
double nearest_real(const NormalForm& form, double speed, Complex place) {
  const Eigen::VectorXcd values = eigenvalues(form, speed);
  return values(nearest_to(place, values)).real();
}

/// Speeds of the track, and further speeds between them at which a real part may touch zero and turn back.
/// There the cubic through its values and slopes comes near zero.
std::vector<double> speeds_to_search(const Track& track, const NormalForm& form) {
  std::vector<double> speeds{track.points.front().speed_rad_per_s};
  for (std::size_t p = 0; p + 1 < track.points.size(); ++p) {
    const TrackPoint &low = track.points[p], &high = track.points[p + 1];
    const double from = low.speed_rad_per_s, step = high.speed_rad_per_s - from;
    for (Eigen::Index i = 0; form.has_friction && i < low.spectrum.values.size(); ++i) {
      const Complex a = low.spectrum.values(i);
      if (a.imag() < 0) continue;
      for (Eigen::Index k = 0; k < high.spectrum.values.size(); ++k) {
        const Complex b = high.spectrum.values(k);
        const double rise = low.spectrum.slopes(i).real() * step,
                     fall = high.spectrum.slopes(k).real() * step;
        const bool same = low.mode[static_cast<std::size_t>(i)] == high.mode[static_cast<std::size_t>(k)];
        const bool same_side = a.real() * b.real() > 0 && b.imag() >= 0;
        if (!same || !same_side || !(rise * fall < 0 && a.real() * rise < 0)) continue;
        const double reach = std::min(std::abs(rise), std::abs(fall));
        if (std::min(std::abs(a.real()), std::abs(b.real())) > reach) continue;
        const double sign = a.real() > 0 ? 1 : -1;
        const double turn = boost::math::tools::brent_find_minima(
                                [&](double speed) { return sign * nearest_real(form, speed, 0.5 * (a + b)); },
                                from, from + step, 20)
                                .first;
        if (turn > speeds.back()) speeds.push_back(turn);
      }
    }
    speeds.push_back(high.speed_rad_per_s);
  }
  return speeds;
}

/// Onsets for a change of the signature, with the names of their modes.
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
    // The first growing root begins a divergence and the last one ends it; the other events only change the
    // number of growing roots.
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

std::string describe_instability(const NormalForm& form, const Track& track, double speed) {
  const Eigen::VectorXcd values = eigenvalues(form, speed);
  const double size = size_of(values), zero = zero_tolerance(form) * size;
  std::map<std::string, std::set<std::string>> modes;
  for (const Complex& value : values) {
    if (value.imag() < 0 || value.real() <= zero) continue;
    const bool diverges = value.imag() <= 1e-7 * size;
    modes[diverges ? "divergence" : "flutter"].insert(describe_mode_near(track, speed, value));
  }
  std::string text;
  for (const auto& [how, names] : modes) {
    text += fmt::format("{}{} of {}", text.empty() ? "" : "; ", how, fmt::join(names, ", "));
  }
  return text.empty() ? "stable" : text;
}

std::vector<Regime> regimes_of(const std::vector<Change>& changes, const Track& track,
                               const NormalForm& form) {
  std::vector<Regime> regimes;
  double from = track.points.front().speed_rad_per_s;
  const auto add = [&](double to) {
    if (!(to > from)) return;
    const std::string text = describe_instability(form, track, from + 0.5 * (to - from));
    if (!regimes.empty() && regimes.back().text == text) {
      regimes.back().to_rad_per_s = to;
    } else {
      regimes.push_back({from, to, text, text == "stable"});
    }
    from = to;
  };
  for (const Change& change : changes) add(change.speed_rad_per_s);
  add(track.points.back().speed_rad_per_s);
  return regimes;
}

void add_stable_windows(const std::vector<Regime>& regimes, std::vector<Onset>& onsets) {
  for (const Regime& regime : regimes) {
    if (!regime.stable) continue;
    onsets.push_back({"stable_from", regime.from_rad_per_s, {}, ""});
    onsets.push_back({"stable_to", regime.to_rad_per_s, {}, ""});
  }
}

/// Closest approaches of neighbouring frequencies of a track without friction, if the gap is less than a
/// quarter of their mean.
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
      // With a smaller gap the modes are uncoupled, and their frequencies simply cross.
      if (!(least < 0.25 * mean && least > 1e-6 * mean)) continue;
      onsets.push_back({"veering", *speed, modes_at(track, *speed, {0, mean}, 2, false),
                        fmt::format("gap {:.6g} rad/s at {:.6g} rad/s", least, mean)});
    }
  }
  return onsets;
}

}  // namespace

void add_onsets(const std::vector<Change>& changes, const Track& track, bool has_friction,
                std::vector<Onset>& onsets, bool only_couplings) {
  for (const Change& change : changes) {
    for (Onset& onset : describe_change(change, track, has_friction)) {
      if (!only_couplings || onset.kind.starts_with("coupling")) onsets.push_back(std::move(onset));
    }
  }
}

Analysis analyse(const System& system, const std::vector<double>& speeds_rad_per_s) {
  const NormalForm form = normal_form(system);
  Analysis analysis;
  analysis.track = track_modes(system, form, speeds_rad_per_s);
  const auto changes = find_changes(form, speeds_to_search(analysis.track, form));
  add_onsets(changes, analysis.track, form.has_friction, analysis.onsets);
  analysis.regimes = regimes_of(changes, analysis.track, form);
  add_stable_windows(analysis.regimes, analysis.onsets);
  analysis.critical_speeds = critical_speeds(system, changes);

  System smooth = system;
  smooth.friction_coefficient = 0;
  const NormalForm smooth_form = normal_form(smooth);
  const Track own_track = form.has_friction ? track_modes(smooth, smooth_form, speeds_rad_per_s) : Track{};
  const Track& smooth_track = form.has_friction ? own_track : analysis.track;
  std::vector<Onset> without = veerings(smooth_track, smooth_form);
  if (form.has_friction) {
    add_onsets(find_changes(smooth_form, speeds_to_search(smooth_track, smooth_form)), smooth_track, false,
               without, true);
    for (Onset& onset : without) onset.note += ", without friction";
  }
  std::move(without.begin(), without.end(), std::back_inserter(analysis.onsets));
  std::ranges::stable_sort(analysis.onsets, {}, &Onset::speed_rad_per_s);
  return analysis;
}

}  // namespace rubsweep::ring
