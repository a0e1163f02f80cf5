#include "rubsweep/ring/analysis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <map>
#include <set>


namespace rubsweep::ring {
namespace {

using Complex = std::complex<double>;

/// Real part of the eigenvalue nearest to `place`.
double nearest_real(const NormalForm& form, double speed, Complex place) {
  const Eigen::VectorXcd values = eigenvalues(form, speed);
  return std::min_element(
             values.begin(), values.end(),
             [&](const Complex& a, const Complex& b) { return std::abs(a - place) < std::abs(b - place); })
      ->real();
}

/// Speeds of the track, and between them those where a real part may touch zero and turn back: the cubic
/// through its values and slopes comes near zero there.
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

std::vector<Onset> onsets_of(const std::vector<Change>& changes, const Track& track, bool has_friction) {
  std::vector<Onset> onsets;
  for (const Change& change : changes) {
    for (Onset& onset : describe_change(change, track, has_friction)) onsets.push_back(std::move(onset));
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

}  // namespace

Analysis analyse(const System& system, const std::vector<double>& speeds_rad_per_s) {
  const NormalForm form = normal_form(system);
  Analysis analysis;
  analysis.track = track_modes(system, form, speeds_rad_per_s);
  const auto changes = find_changes(form, speeds_to_search(analysis.track, form));
  analysis.onsets = onsets_of(changes, analysis.track, form.has_friction);
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
    for (Onset& onset : onsets_of(find_changes(smooth_form, speeds_to_search(smooth_track, smooth_form)),
                                  smooth_track, false)) {
      if (onset.kind.starts_with("coupling")) without.push_back(std::move(onset));
    }
    for (Onset& onset : without) onset.note += ", without friction";
  }
  std::move(without.begin(), without.end(), std::back_inserter(analysis.onsets));
  std::stable_sort(analysis.onsets.begin(), analysis.onsets.end(),
                   [](const Onset& a, const Onset& b) { return a.speed_rad_per_s < b.speed_rad_per_s; });
  return analysis;
}

}  // namespace rubsweep::ring
