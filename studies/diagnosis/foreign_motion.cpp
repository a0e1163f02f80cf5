#include "foreign_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double size_m = 1e-4;  ///< amplitude of the line at 1X

double between(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double between_logarithms(double low, double high, std::mt19937_64& random) {
  return low * std::pow(high / low, between(0, 1, random));
}
Complex any_phase(double amplitude, std::mt19937_64& random) {
  return std::polar(amplitude, between(-pi, pi, random));
}

/// Sum of spectral lines over the turns.
class Lines {
 public:
  Lines(int turns, int samples_of_a_turn)
      : z_(static_cast<std::size_t>(turns * samples_of_a_turn)), n_(samples_of_a_turn) {}
  void add(double order, Complex amplitude) {
    for (std::size_t k = 0; k < z_.size(); ++k)
      z_[k] += amplitude * std::polar(1.0, 2 * pi * order * static_cast<double>(k) / n_);
  }
  std::vector<Complex>& samples() { return z_; }
  double turns_at(std::size_t k) const { return static_cast<double>(k) / n_; }

 private:
  std::vector<Complex> z_;
  int n_;
};

/// Unbalance on slightly unequal supports.
Lines unbalanced(int turns, int n, std::mt19937_64& random) {
  Lines lines(turns, n);
  lines.add(1, any_phase(size_m, random));
  lines.add(-1, any_phase(size_m * between_logarithms(1e-3, 0.2, random), random));
  return lines;
}

void add_coupling(Lines& lines, std::mt19937_64& random) {
  const double second = size_m * between(0.5, 2, random);
  lines.add(2, any_phase(second * between(0.3, 1, random), random));
  lines.add(-2, any_phase(second * between(0.3, 1, random), random));
  for (const int order : {3, -3, 4, -4})
    lines.add(order, any_phase(second * between_logarithms(0.01, 0.2, random), random));
}

/// Impacts of rolling elements on a fault of the outer race: their rate slips slightly, and the shaft speed
/// modulates them.
void add_bearing(Lines& lines, std::mt19937_64& random) {
  const double rate = between(3.02, 3.9, random), strength = size_m * between(0.1, 0.5, random);
  const Complex direction = any_phase(1, random);
  double slip = 0;
  for (std::size_t k = 0; k < lines.samples().size(); ++k) {
    slip += 0.004 * std::normal_distribution<double>()(random);
    const double angle = 2 * pi * rate * lines.turns_at(k) + slip;
    const double load = 1 + 0.5 * std::cos(2 * pi * lines.turns_at(k));
    lines.samples()[k] += direction * strength * load * (std::cos(angle) + 0.5 * std::cos(2 * angle));
  }
}

/// Forward whirl of wandering frequency below half the shaft speed.
void add_oil_whirl(Lines& lines, std::mt19937_64& random) {
  const double order = between(0.42, 0.48, random), amplitude = size_m * between_logarithms(0.3, 3, random);
  double phase = between(-pi, pi, random), swell = 1;
  for (std::size_t k = 0; k < lines.samples().size(); ++k) {
    phase += 0.002 * std::normal_distribution<double>()(random);
    swell += 0.002 * std::normal_distribution<double>()(random) + 1e-3 * (1 - swell);
    lines.samples()[k] += amplitude * swell * std::polar(1.0, 2 * pi * order * lines.turns_at(k) + phase);
  }
}

/// A surface profile seen by both probes; the one at 90 degrees sees it a quarter turn later.
void add_run_out(Lines& lines, std::mt19937_64& random) {
  const double strength = size_m * between(0.3, 2, random);
  for (int order = 1; order <= 10; ++order) {
    const Complex a = any_phase(strength / std::sqrt(order) * between(0.2, 1, random), random);
    for (std::size_t k = 0; k < lines.samples().size(); ++k) {
      const Complex turned = a * std::polar(1.0, 2 * pi * order * lines.turns_at(k));
      const Complex later = turned * std::polar(1.0, -order * pi / 2);
      lines.samples()[k] += Complex(turned.real(), later.real());
    }
  }
}

/// A pedestal that lifts off: its vertical stiffness falls to a share while the shaft is above its rest
/// position.
std::vector<Complex> loose_support(double speed_ratio, double damping_ratio, int turns, int n,
                                   std::mt19937_64& random) {
  const double share = between(0.2, 0.7, random), rest = between(0, 0.5, random), e = between(0.3, 1, random),
               y_over_x = between(0.8, 1, random);
  const int settling = 400, steps_of_a_sample = 8;
  const double h = 2 * pi / speed_ratio / (n * steps_of_a_sample);
  double x = 0, y = 0, u = 0, v = 0, t = 0;  // time x natural angular frequency
  const auto rate = [&](double at, double px, double py, double pu, double pv, double& ax, double& ay) {
    const double force = e * speed_ratio * speed_ratio;
    const double lift = py > rest ? py - rest : 0;
    ax = force * std::cos(speed_ratio * at) - px - 2 * damping_ratio * pu;
    ay = force * std::sin(speed_ratio * at) - y_over_x * py + (1 - share) * lift - 2 * damping_ratio * pv;
  };
  std::vector<Complex> samples;
  for (long k = 0; k < static_cast<long>(settling + turns) * n; ++k) {
    if (k >= static_cast<long>(settling) * n) samples.emplace_back(x * size_m, y * size_m);
    for (int s = 0; s < steps_of_a_sample; ++s) {
      double ax, ay, bx, by;
      rate(t, x, y, u, v, ax, ay);
      // Velocity Verlet with damping at mid-step.
      const double um = u + h / 2 * ax, vm = v + h / 2 * ay;
      x += h * um;
      y += h * vm;
      t += h;
      rate(t, x, y, um, vm, bx, by);
      u = um + h / 2 * bx;
      v = vm + h / 2 * by;
    }
  }
  return samples;
}

}  // namespace

std::string_view to_string(Foreign cause) {
  switch (cause) {
    case Foreign::misaligned_coupling: return "misaligned_coupling";
    case Foreign::bearing_fault: return "bearing_fault";
    case Foreign::loose_support: return "loose_support";
    case Foreign::oil_whirl: return "oil_whirl";
    case Foreign::electrical_run_out: return "electrical_run_out";
    case Foreign::clipped_sensor: return "clipped_sensor";
  }
  throw std::invalid_argument("foreign cause: no such enumerator");
}

std::vector<Complex> foreign_motion(Foreign cause, double speed_ratio, double damping_ratio, int turns,
                                    int samples_of_a_turn, std::mt19937_64& random) {
  if (cause == Foreign::loose_support)
    return loose_support(speed_ratio, damping_ratio, turns, samples_of_a_turn, random);
  Lines lines = unbalanced(turns, samples_of_a_turn, random);
  switch (cause) {
    case Foreign::misaligned_coupling: add_coupling(lines, random); break;
    case Foreign::bearing_fault: add_bearing(lines, random); break;
    case Foreign::oil_whirl: add_oil_whirl(lines, random); break;
    case Foreign::electrical_run_out: add_run_out(lines, random); break;
    case Foreign::clipped_sensor:  // affects only the readings
    case Foreign::loose_support: break;
  }
  return lines.samples();
}
