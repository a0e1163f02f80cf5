#include "rubsweep/measurement/scope/verdict.hpp"

#include <algorithm>
#include <cstddef>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/spectrum/discrete_lines.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/measurement/scope/line_noise.hpp"
#include "rubsweep/measurement/scope/repeating_angles.hpp"
#include "rubsweep/measurement/scope/verdict_lines.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;
using response::spectrum::SpectrumWorkspace;

std::vector<MeasuredLine> lines_of(std::span<const Complex> orbit, int turns) {
  const int last = std::min(static_cast<int>(most_order * turns), static_cast<int>(orbit.size()) / 2 - 1);
  std::vector<MeasuredLine> lines;
  for (int k = -last; const Complex amplitude_m : lines_of_period(orbit, last))
    lines.push_back({static_cast<double>(k++) / turns, amplitude_m});
  return lines;
}

/// A longer period that has a suspicious line.
std::optional<DoubtfulPeriod> doubtful_period(const Lines& spectrum, int period, int longest,
                                              const Threshold& threshold) {
  for (int n = 2 * period; n <= longest; n += period) {
    if (spectrum.turns % n != 0) continue;
    const auto [amplitude_m, noise] = highest_beside(spectrum, period, n);
    if (!(amplitude_m > std::max(noise * threshold.suspicious_m, threshold.floor_m))) continue;
    // The noise of a line, and the smallest visible line, fall with the square root of the recording length.
    const double ratio = threshold.visible_m(noise) / amplitude_m;
    return DoubtfulPeriod{n, amplitude_m, spectrum.turns * (ratio * ratio - 1)};
  }
  return std::nullopt;
}

/// Samples over whole turns, and the way they were read.
struct Motion {
  std::span<const Complex> samples;
  std::size_t per_turn = 0;
  Reading reading;

  double most_order_looked_at() const { return scope::most_order_looked_at(reading); }
  std::vector<Complex> repeating_after(int turns) const {
    return at_repeating_angles(samples, static_cast<int>(per_turn), turns, most_order_looked_at(),
                               reading.angle_doubt);
  }
  /// Samples without the slow modulation of their lines at whole orders. Variations that repeat after `turns`
  /// turns are kept.
  Levelled levelled_once(std::span<const Complex> motion, int turns) const {
    return levelled(motion, {.repeats = turns});
  }
  Levelled levelled(std::span<const Complex> motion, SlowModulation slow) const {
    slow.most_order = most_order_looked_at();
    slow.most_modulation = reading.thresholds.most_modulation;
    return without_slow_modulation(motion, static_cast<int>(per_turn), slow);
  }
};

/// Spectrum of the last samples that form whole periods of n turns.
Lines spectrum_of_periods(const Motion& motion, std::span<const Complex> samples, int n,
                          SpectrumWorkspace& workspace) {
  const auto window = whole_periods(samples, static_cast<std::size_t>(n) * motion.per_turn);
  const int turns = static_cast<int>(window.size() / motion.per_turn);
  return {response::spectrum::full_spectrum(window, turns, workspace), motion.most_order_looked_at(),
          motion.reading.thresholds.least_share, motion.reading.integration};
}

/// Whether the first and the second half of a motion, without slow modulation, have the same lines.
bool keeps_lines(const Motion& motion, std::span<const Complex> samples, SpectrumWorkspace& workspace) {
  const std::vector<Complex> all = motion.levelled_once(samples, 1).samples;
  const auto halves = std::span(all);
  return response::spectrum::same_discrete_lines(halves.first(all.size() / 2), halves.last(all.size() / 2),
                                                 workspace);
}

/// Finds the class and the shortest period outside of whose lines nothing is visible, and a longer period, if
/// one cannot be ruled out. Returns the corrected samples that show this period.
std::vector<Complex> find_period(const Motion& motion, SpectrumWorkspace& workspace, Verdict& verdict) {
  for (int n = 1; n <= verdict.longest_period; ++n) {
    std::vector<Complex> samples = motion.repeating_after(n);
    const Levelled once = motion.levelled_once(samples, n);
    // First only the amplitudes of a longer period's lines may vary slowly, then also their phases.
    const Levelled steady = n == 1 ? once : motion.levelled(once.samples, {.period = n, .in_phase = true});
    const Levelled levelled = n == 1 ? once : motion.levelled(steady.samples, {.period = n});
    if (n == 1) verdict.refused_modulation_m = once.refused_m;
    const Lines spectrum = spectrum_of_periods(motion, levelled.samples, n, workspace);
    const Threshold threshold = threshold_of(spectrum);
    if (is_visible_beside(spectrum, n, threshold)) continue;
    // A line near a multiple of 1/n looks like a slowly rotating line at this multiple.
    if (n > 1) {
      verdict.order_room = room_of_period(steady.samples, motion.per_turn, motion.reading, n,
                                          {threshold.seen_m, threshold.floor_m}, workspace);
      if (!verdict.order_room) continue;
    }
    verdict.motion = n == 1 ? MeasuredClass::synchronous : MeasuredClass::subharmonic;
    verdict.period = n;
    verdict.turns = spectrum.turns;
    if (n > 1 && may_be_torus(verdict)) verdict.motion = MeasuredClass::subharmonic_or_torus;
    verdict.noise_m = threshold.noise_m;
    verdict.visible_m = threshold.visible_m();
    verdict.modulation_m = n == 1 ? once.modulation_m
                                  : std::hypot(once.modulation_m, steady.modulation_m, levelled.modulation_m);
    verdict.refused_modulation_m = 0;
    const Beside beside = highest_beside(spectrum, n);
    verdict.beside_m = beside.amplitude_m;
    verdict.seen_m = beside.noise * threshold.seen_m;
    for (int m = 2 * n; m <= verdict.longest_period && !verdict.doubtful; m += n) {
      const Lines longer = spectrum_of_periods(motion, levelled.samples, m, workspace);
      verdict.doubtful = doubtful_period(longer, n, m, threshold_of(longer));
    }
    return samples;
  }
  // Where no line is locked to the shaft, the angles of best repetition are arbitrary, so the original
  // samples are classified.
  verdict.motion = MeasuredClass::quasi_periodic;
  if (!keeps_lines(motion, motion.samples, workspace)) {
    std::vector<Complex> moved = motion.repeating_after(1);
    if (keeps_lines(motion, moved, workspace)) return moved;
    verdict.motion = MeasuredClass::aperiodic;
  }
  return {motion.samples.begin(), motion.samples.end()};
}

/// Sets the mean orbit of a period and its lines. Without a period, the orbit has only the last turns, as
/// many as a figure can show. Because these turns are fewer, their noise is larger.
void take_orbit(std::span<const Complex> samples, std::size_t per_turn, Verdict& verdict) {
  if (verdict.period) {
    const int n = *verdict.period;
    const std::size_t length = static_cast<std::size_t>(n) * per_turn;
    verdict.orbit_m =
        recording::integrated(mean_period(whole_periods(samples, length), length), n, verdict.integration);
    verdict.lines = lines_of(verdict.orbit_m, n);
    return;
  }
  const int turns = std::min(verdict.turns, most_aperiodic_turns);
  const double fewer = std::sqrt(static_cast<double>(verdict.turns) / turns);
  verdict.turns = turns;
  verdict.noise_m *= fewer;
  verdict.visible_m *= fewer;
  const auto last = samples.last(static_cast<std::size_t>(turns) * per_turn);
  verdict.orbit_m = recording::integrated({last.begin(), last.end()}, turns, verdict.integration);
  verdict.lines = lines_of(verdict.orbit_m, turns);
}

/// Sets the share of the energy in forward whirl, and its uncertainty by noise.
void measure_whirl(Verdict& verdict) {
  double forward = 0, backward = 0;
  for (const MeasuredLine& line : verdict.lines) {
    if (line.order > 0) forward += std::norm(line.amplitude_m);
    if (line.order < 0) backward += std::norm(line.amplitude_m);
  }
  const double all = forward + backward;
  verdict.whirl = response::spectrum::whirl_kind(forward, backward);
  verdict.forward_share = forward / all;
  // Error propagation for f / (f + b), with the errors df = 2 sqrt(f) s and db = 2 sqrt(b) s of the energies.
  verdict.forward_share_uncertainty = 2 * verdict.noise_m * std::sqrt(forward * backward / all) / all;
}

}  // namespace

std::string_view to_string(MeasuredClass value) { return enumerator_word(value); }

Verdict judge(std::span<const Complex> displacement_m, int samples_per_revolution, bool plane,
              const Reading& reading) {
  const Motion motion{displacement_m, static_cast<std::size_t>(samples_per_revolution), reading};
  const int turns = static_cast<int>(displacement_m.size() / motion.per_turn);
  if (turns < fewest_periods + 1) throw SolverError("judge: too few turns");
  SpectrumWorkspace workspace;
  const Threshold first = threshold_of(spectrum_of_periods(motion, displacement_m, 1, workspace));
  Verdict verdict{.turns = turns,
                  .longest_period = longest_period_in(turns),
                  .noise_m = first.noise_m,
                  .visible_m = first.visible_m(),
                  .thresholds = reading.thresholds,
                  .integration = reading.integration};
  std::vector<Complex> samples;
  // Rounding may leave a small line in the recording of a shaft at standstill.
  const Complex farthest = std::ranges::max(displacement_m, {}, [](Complex z) { return std::abs(z); });
  if (first.largest_m <= std::max(first.visible_m(), 1e-12 * std::abs(farthest))) {
    samples.assign(displacement_m.begin(), displacement_m.end());
    verdict.period = 1;
    verdict.motion = MeasuredClass::at_rest;
  } else {
    samples = find_period(motion, workspace, verdict);
  }
  if (!verdict.period)
    verdict.discrete_lines =
        discrete_lines_of(samples, motion.per_turn, reading, {first.seen_m, first.floor_m}, workspace);
  take_orbit(samples, motion.per_turn, verdict);
  add_uncertainties(reading, verdict);
  if (plane && verdict.motion != MeasuredClass::at_rest) {
    verdict.shape = response::spectrum::orbit_kind(
        verdict.orbit_m, response::spectrum::full_spectrum(
                             verdict.orbit_m, verdict.period.value_or(verdict.turns), workspace));
    measure_whirl(verdict);
  }
  return verdict;
}

Verdict judge(const recording::Recording& recording, const Thresholds& thresholds) {
  return judge(recording.measured_m.empty() ? recording.displacement_m : recording.measured_m,
               recording::samples_per_revolution, recording.plane,
               {recording.sampling_rate_hz / recording.mean_speed_hz(), recording.angle_doubt, thresholds,
                recording.integration});
}

}  // namespace rubsweep::scope
