#include "rubsweep/core/response/spectrum/comb.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

namespace rubsweep::response::spectrum {
namespace {

using Complex = std::complex<double>;

constexpr int farthest = 16;

double amplitude_at(std::span<const Complex> z, int samples_per_revolution, double order) {
  const double two_pi = 2 * std::numbers::pi, count = static_cast<double>(z.size());
  const Complex back = std::polar(1.0, -two_pi * order / samples_per_revolution);
  const Complex along = std::polar(1.0, two_pi / count);
  Complex line = 1, window = std::polar(1.0, two_pi / (2 * count)), sum = 0;
  for (const Complex& sample : z) {
    sum += (1 - window.real()) * line * sample;
    line *= back;
    window *= along;
  }
  return std::abs(sum) / count;  // the weights 1 - cos have mean 1
}

constexpr int largest_multiple = 16;
constexpr auto fewest_turns = static_cast<std::size_t>(fewest_comb_turns);

/// Interpolates samples a fraction of a step later, by Lagrange's polynomial through 6 of them.
struct Delay {
  std::size_t whole = 0;  ///< index of the first of the 6
  std::array<double, 6> weights{};

  explicit Delay(double samples) {
    const double floor = std::floor(samples);
    whole = static_cast<std::size_t>(floor) - 2;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      weights[i] = 1;
      for (std::size_t j = 0; j < weights.size(); ++j) {
        if (j == i) continue;
        const double x = samples - floor + 2 - static_cast<double>(j);
        weights[i] *= x / (static_cast<double>(i) - static_cast<double>(j));
      }
    }
  }

  Complex read(const std::vector<Complex>& w, std::size_t from) const {
    Complex sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * w[from + whole + i];
    return sum;
  }
};

/// The motion in the rotating frame.
class TurningOrbit {
 public:
  TurningOrbit(std::span<const Complex> displacement_m, int samples_per_revolution) {
    const auto per_turn = static_cast<std::size_t>(samples_per_revolution);
    w_.reserve(displacement_m.size());
    for (std::size_t j = 0; j < displacement_m.size(); ++j) {
      const double phase = 2 * std::numbers::pi * static_cast<double>(j % per_turn) / samples_per_revolution;
      w_.push_back(displacement_m[j] * std::polar(1.0, -phase));
    }
    mean_ = std::accumulate(w_.begin(), w_.end(), Complex{}) / static_cast<double>(w_.size());
    for (const Complex& w : w_) mean_square_ += std::norm(w - mean_) / static_cast<double>(w_.size());
  }

  const std::vector<Complex>& samples() const { return w_; }
  Complex mean() const { return mean_; }
  double mean_square() const { return mean_square_; }  ///< mean square of w about its mean

  /// Root mean square of w(t + lag) - w(t), divided by that of w about its mean. `lag` in samples, >= 4.
  double return_error(double lag) const {
    const Delay delay(lag);
    double square = 0;
    for (std::size_t j = 0; last(delay, j) < w_.size(); j += stride)
      square += std::norm(delay.read(w_, j) - w_[j]);
    return std::sqrt(square / static_cast<double>(visited(delay)) / mean_square_);
  }

  /// Gauss-Newton step of the lag towards the smallest return error.
  double lag_step(double lag) const {
    const Delay delay(lag), before(lag - 0.5), after(lag + 0.5);
    double moment = 0, square = 0;
    for (std::size_t j = 0; last(after, j) < w_.size(); j += stride) {
      const Complex slope = after.read(w_, j) - before.read(w_, j);
      moment += (std::conj(slope) * (delay.read(w_, j) - w_[j])).real();
      square += std::norm(slope);
    }
    return square > 0 ? -moment / square : 0;
  }

 private:
  /// Every seventh sample is enough, and seven has no common factor with a power of two.
  static constexpr std::size_t stride = 7;

  static std::size_t last(const Delay& delay, std::size_t from) {
    return from + delay.whole + delay.weights.size() - 1;
  }
  std::size_t visited(const Delay& delay) const { return (w_.size() - last(delay, 0) + stride - 1) / stride; }

  std::vector<Complex> w_;
  Complex mean_;
  double mean_square_ = 0;
};

/// Position of the largest line between bins. Under a Hann window, neighbours a and b of a line at a distance
/// of d bins have b / a = (1 + d) / (2 - d) (R. Grandke, IEEE Trans. Instrum. Meas. 32 (1983) 350). Bin 0,
/// which held the mean, is skipped.
double largest_line(const FullSpectrum& spectrum) {
  int k = 0;
  for (int j = spectrum.first_line() + 1; j < spectrum.last_line(); ++j) {
    if (j != 0 && (k == 0 || spectrum.amplitude(j) > spectrum.amplitude(k))) k = j;
  }
  const double here = spectrum.amplitude(k), below = spectrum.amplitude(k - 1),
               above = spectrum.amplitude(k + 1);
  return above > below ? k + (2 * above - here) / (above + here) : k - (2 * below - here) / (below + here);
}

/// Refines the period, in samples, over longer and longer lags; empty when it does not close or leaves the
/// line.
std::optional<double> closing_period(const TurningOrbit& orbit, double first_guess, double margin) {
  const double longest_lag = static_cast<double>(orbit.samples().size()) / 2;
  double period = first_guess;
  for (double periods = 1; periods * period <= longest_lag; periods *= 2) {
    for (int i = 0; i < 3; ++i) period += orbit.lag_step(periods * period) / periods;
    if (!(std::abs(period - first_guess) <= margin)) return std::nullopt;
    if (orbit.return_error(periods * period) > comb_tolerance) return std::nullopt;
  }
  return period;
}

/// Factor by which the window increases the energy of a line.
constexpr double energy_under_hann = 1.5;

double energy_share(const TurningOrbit& orbit, const FullSpectrum& spectrum, double spacing_bins) {
  if (spacing_bins < 2 * (2 * hann_half_width + 1)) return 0;
  double held = 0;
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    const double off = std::remainder(k, spacing_bins);
    if (std::abs(off) <= hann_half_width + 0.5) held += spectrum.amplitude(k) * spectrum.amplitude(k);
  }
  const double at_1x = std::norm(orbit.mean());
  return (at_1x + held / energy_under_hann) / (at_1x + spectrum.energy_without_mean() / energy_under_hann);
}

}  // namespace

std::optional<Comb> find_comb(std::span<const Complex> displacement_m, int samples_per_revolution,
                              SpectrumWorkspace& workspace) {
  const std::size_t count = displacement_m.size();
  if (samples_per_revolution < 4 || count % static_cast<std::size_t>(samples_per_revolution) != 0 ||
      count < fewest_turns * static_cast<std::size_t>(samples_per_revolution)) {
    throw SolverError(fmt::format("a comb takes {} whole turns, got {} samples of {} per turn", fewest_turns,
                                  count, samples_per_revolution));
  }
  const TurningOrbit orbit(displacement_m, samples_per_revolution);
  if (!(orbit.mean_square() > 0)) return std::nullopt;
  const FullSpectrum spectrum = full_spectrum(under_hann_window(orbit.samples()), 1, workspace);
  const double line = std::abs(largest_line(spectrum));
  const double samples = static_cast<double>(count);
  double bins = line;
  bool closed = false;
  for (int k = 1; k <= largest_multiple && !closed; ++k) {
    const double guess = k * samples / line;
    if (guess > samples / 4 || guess < 4) continue;
    // The line is known to within a bin.
    const auto period = closing_period(orbit, guess, guess / line);
    if (!period) continue;
    closed = true;
    bins = samples / *period;
  }
  const double turns = samples / samples_per_revolution;
  return Comb{.spacing = bins / turns, .closed = closed, .energy_share = energy_share(orbit, spectrum, bins)};
}

std::optional<SpectralLine> largest_comb_line(std::span<const Complex> displacement_m,
                                              int samples_per_revolution, double spacing) {
  const double bin = samples_per_revolution / static_cast<double>(displacement_m.size());
  std::optional<SpectralLine> largest;
  for (int k = -farthest; k <= farthest; ++k) {
    const double order = 1 + k * spacing;
    if (std::abs(order) < bin || std::abs(order) >= samples_per_revolution / 2.0) continue;
    const double amplitude = amplitude_at(displacement_m, samples_per_revolution, order);
    if (amplitude > (largest ? largest->amplitude_m : 0))
      largest = {.order = order, .amplitude_m = amplitude};
  }
  return largest;
}

}  // namespace rubsweep::response::spectrum
