#include "rubsweep/diagnose/answer/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::diagnose::answer {
namespace {

using Complex = std::complex<double>;

Complex correlation(const MotionLines& recorded, const MotionLines& simulated, double angle_rad) {
  Complex sum = 0;
  const int last = std::min(recorded.last(), simulated.last());
  const Complex step = std::polar(1.0, angle_rad / recorded.turns);
  Complex shift = std::polar(1.0, -last * angle_rad / recorded.turns);
  for (int k = -last; k <= last; ++k, shift *= step)
    if (k != 0) sum += std::conj(recorded.at(k)) * simulated.at(k) * shift;
  return sum;
}

}  // namespace

Overlay lay_over(const MotionLines& recorded, const MotionLines& simulated, bool plane) {
  constexpr int begins_of_a_turn = 64;
  const auto agreement = [&](const Complex& c) { return plane ? std::abs(c) : c.real(); };
  double angle = 0;
  Complex best = correlation(recorded, simulated, 0);
  for (int j = 1; j < begins_of_a_turn * recorded.turns; ++j) {
    const double at = 2 * std::numbers::pi * j / begins_of_a_turn;
    const Complex c = correlation(recorded, simulated, at);
    if (agreement(c) > agreement(best)) {
      best = c;
      angle = at;
    }
  }
  const double scale = size_of(recorded) / size_of(simulated);
  const Complex turn = plane ? std::conj(best) / std::abs(best) : 1;
  Overlay overlay{{recorded.turns, Eigen::VectorXcd::Zero(recorded.amplitude.size())}, 0};
  const int last = std::min(recorded.last(), simulated.last());
  double left = 0;
  for (int k = -recorded.last(); k <= recorded.last(); ++k) {
    if (k == 0) continue;
    if (std::abs(k) <= last)
      overlay.simulated.at(k) = scale * turn * std::polar(1.0, k * angle / recorded.turns) * simulated.at(k);
    left += std::norm(recorded.at(k) - overlay.simulated.at(k));
  }
  overlay.unexplained = left / (size_of(recorded) * size_of(recorded));
  return overlay;
}

}  // namespace rubsweep::diagnose::answer
