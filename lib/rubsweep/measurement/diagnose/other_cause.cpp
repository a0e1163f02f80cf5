#include "rubsweep/measurement/diagnose/other_cause.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

double between_logarithms(double low, double high, RandomStream& random) {
  return low * std::pow(high / low, random.uniform());
}

/// Amplitude shares of the forward and the backward part of a component; their squares add up to 1.
struct Whirl {
  double forward = 1, backward = 0;
};

/// Whirl of a forced vibration: any ellipse.
Whirl any_ellipse(RandomStream& random) {
  const double share = 2 * pi * random.uniform();
  return {std::cos(share), std::sin(share)};
}

/// Whirl of a self-excited vibration: nearly a circle.
Whirl near_circle(bool forward, RandomStream& random) {
  const double rest = between_logarithms(1e-3, 0.3, random), most = std::sqrt(1 - rest * rest);
  return forward ? Whirl{most, rest} : Whirl{rest, most};
}

/// Sum of components. The phase of each is the shaft angle times its order, plus a random walk.
class Vibration {
 public:
  Vibration(std::size_t count, int samples_of_a_turn) : samples_of_a_turn_(samples_of_a_turn), z_(count) {}

  void add(double order, double amplitude, const Whirl& whirl, const std::vector<double>& wandered,
           RandomStream& random) {
    const Complex forward = std::polar(amplitude * whirl.forward, 2 * pi * random.uniform()),
                  backward = std::polar(amplitude * whirl.backward, 2 * pi * random.uniform());
    add(order, forward, backward, wandered);
  }

  /// Adds a component along a straight line across the shaft, `direction` radians from +x, instead of an
  /// ellipse.
  void add_along(double order, double amplitude, double direction, RandomStream& random) {
    const double phase = 2 * pi * random.uniform();
    add(order, std::polar(amplitude / 2, direction + phase), std::polar(amplitude / 2, direction - phase),
        {});
  }

  std::vector<Complex> samples() && { return std::move(z_); }

  /// Phase of a random walk for every sample.
  std::vector<double> wandering(RandomStream& random) const {
    const double step = between_logarithms(1e-3, 0.2, random) / std::sqrt(samples_of_a_turn_);
    std::vector<double> angle(z_.size());
    double at = 0;
    for (double& x : angle) x = at += step * random.normal();
    return angle;
  }

 private:
  void add(double order, Complex forward, Complex backward, const std::vector<double>& wandered) {
    for (std::size_t k = 0; k < z_.size(); ++k) {
      const double angle =
          2 * pi * order * static_cast<double>(k) / samples_of_a_turn_ + (wandered.empty() ? 0 : wandered[k]);
      z_[k] += forward * std::polar(1.0, angle) + backward * std::polar(1.0, -angle);
    }
  }

  int samples_of_a_turn_;
  std::vector<Complex> z_;
};

/// Adds whole multiples of the shaft speed: one multiple, or a series of decreasing amplitude.
void add_multiples(Vibration& vibration, double amplitude, RandomStream& random) {
  if (random.uniform() < 0.5) {
    const double order = 2 + std::floor(4 * random.uniform());
    vibration.add(order, amplitude, any_ellipse(random), {}, random);
    return;
  }
  const double decay = 1.5 * random.uniform();
  for (int order = 2; order <= 8; ++order) {
    const double strength = amplitude * std::pow(order, -decay) * between_logarithms(0.2, 1, random);
    vibration.add(order, strength, any_ellipse(random), {}, random);
  }
}

/// Adds a component of any order, forced or self-excited; it may have a harmonic and sidebands.
void add_free_order(Vibration& vibration, double amplitude, RandomStream& random) {
  const double order = random.uniform() < 0.5 ? 0.2 + 0.8 * random.uniform() : 1 + 4 * random.uniform();
  const Whirl whirl =
      random.uniform() < 0.5 ? any_ellipse(random) : near_circle(random.uniform() < 0.5, random);
  const std::vector<double> wandered = vibration.wandering(random);
  vibration.add(order, amplitude, whirl, wandered, random);
  if (random.uniform() < 0.5) {
    std::vector<double> twice = wandered;
    for (double& angle : twice) angle *= 2;
    vibration.add(2 * order, amplitude * between_logarithms(0.1, 1, random), any_ellipse(random), twice,
                  random);
  }
  if (random.uniform() < 0.5)
    for (const int side : {-1, 1})
      vibration.add(order + side, amplitude * between_logarithms(0.05, 0.7, random), any_ellipse(random),
                    wandered, random);
}

/// Adds the whirl of an oil film: forward at slightly less than half the shaft speed (Muszynska,
/// Rotordynamics, 2005, chapter 4).
void add_oil_whirl(Vibration& vibration, double amplitude, RandomStream& random) {
  const double order = 0.38 + 0.12 * random.uniform();
  const std::vector<double> wandered = vibration.wandering(random);
  vibration.add(order, amplitude, near_circle(true, random), wandered, random);
}

/// Adds the vibration of a support that is loose or stiffer to one side. The stiffness changes along one
/// direction. In this direction the shaft vibrates at multiples of its speed, sometimes of half its speed,
/// with decreasing amplitudes (Muszynska and Goldman, Chaos, Solitons and Fractals 5, 1995).
void add_directional_series(Vibration& vibration, RandomStream& random) {
  const double direction = 2 * pi * random.uniform();
  const double decay = between_logarithms(0.05, 0.7, random);
  double amplitude = between_logarithms(0.03, 1, random);
  for (int order = 2; order <= 8; ++order) {
    vibration.add_along(order, amplitude * between_logarithms(0.3, 1, random), direction, random);
    amplitude *= decay;
  }
  if (random.uniform() < 0.75) return;
  amplitude = between_logarithms(0.03, 1, random);
  for (int half = 1; half <= 7; half += 2) {
    vibration.add_along(half / 2.0, amplitude * between_logarithms(0.3, 1, random), direction, random);
    amplitude *= decay;
  }
}

}  // namespace

OtherVibration another_cause(std::size_t count, int samples_of_a_turn, RandomStream& random) {
  Vibration vibration(count, samples_of_a_turn);
  constexpr double unequal_supports = 0.125;
  const bool alone = random.uniform() < unequal_supports;
  const double backward = alone ? between_logarithms(0.3, 1, random) : between_logarithms(1e-3, 0.5, random);
  vibration.add(1, 1, {1, backward}, {}, random);
  std::string parts = alone ? "unequal_supports" : "";
  const int components = alone ? 0 : 1 + static_cast<int>(4 * random.uniform() * random.uniform());
  for (int k = 0; k < components; ++k) {
    const double amplitude = between_logarithms(0.05, 3, random), kind = random.uniform();
    if (k > 0) parts += '+';
    if (kind < 0.3) {
      parts += "multiples";
      add_multiples(vibration, amplitude, random);
    } else if (kind < 0.6) {
      parts += "free_order";
      add_free_order(vibration, amplitude, random);
    } else if (kind < 0.8) {
      parts += "looseness";
      add_directional_series(vibration, random);
    } else {
      parts += "oil_whirl";
      add_oil_whirl(vibration, amplitude, random);
    }
  }
  return {std::move(vibration).samples(), std::move(parts)};
}

MotionLines vibration_of_another_cause(int turns, RandomStream& random,
                                       response::spectrum::SpectrumWorkspace& workspace) {
  constexpr int samples_of_a_turn = 32;
  const std::size_t count = static_cast<std::size_t>(turns) * samples_of_a_turn;
  return lines_of(another_cause(count, samples_of_a_turn, random).samples, turns, most_order, workspace);
}

MotionLines vibration_at_another_speed(const MotionLines& lines, RandomStream& random,
                                       response::spectrum::SpectrumWorkspace& workspace) {
  constexpr int line_bins = 2;
  const double kind = random.uniform(), size = between_logarithms(0.1, 10, random),
               off_1x = kind < 1.0 / 3 ? 0 : between_logarithms(0.2, 5, random);
  MotionLines there = kind < 2.0 / 3 ? lines : vibration_of_another_cause(lines.turns, random, workspace);
  for (int k = -there.last(); k <= there.last(); ++k) {
    const bool other = kind < 2.0 / 3 && k != 0 && std::abs(std::abs(k) - there.turns) > line_bins;
    there.at(k) *= size * (other ? off_1x : 1);
  }
  // A load that moves the shaft stays.
  there.at(0) = lines.at(0);
  return there;
}

}  // namespace rubsweep::diagnose
