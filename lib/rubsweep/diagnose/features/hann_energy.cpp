#include "rubsweep/diagnose/features/hann_energy.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace rubsweep::diagnose::features {

HannEnergy::HannEnergy(const MotionLines& lines, bool plane)
    : turns_(lines.turns), last_(lines.last()), first_(plane ? -last_ : 1) {
  const double all = size_of(lines) * size_of(lines) * (plane ? 1 : 0.5);
  share_.assign(2 * static_cast<std::size_t>(last_) + 1, 0);
  for (int k = first_; k <= last_; ++k) {
    if (k == 0) continue;
    const auto line = [&](int j) {
      return j == 0 || std::abs(j) > last_ ? std::complex<double>(0) : lines.at(j);
    };
    // The window keeps 3/8 of the energy of a line amidst a bin.
    share_[index(k)] = std::norm(line(k) / 2.0 - (line(k - 1) + line(k + 1)) / 4.0) * 8 / 3 / all;
  }
}

double HannEnergy::near(double order, int bins) const {
  const int middle = static_cast<int>(std::lround(order * turns_));
  double sum = 0;
  for (int k = middle - bins; k <= middle + bins; ++k) sum += (*this)[k];
  return sum;
}

bool between_multiples(const HannEnergy& energy, int k, int bins) {
  const double order = static_cast<double>(k) / energy.turns();
  return std::abs(k - std::lround(order) * energy.turns()) > bins;
}

int strongest_between_multiples(const HannEnergy& energy, const std::vector<int>& others) {
  constexpr int apart = 2;
  int best = 0;
  for (int k = energy.first(); k <= energy.last(); ++k) {
    const bool taken = std::ranges::any_of(others, [&](int other) { return std::abs(k - other) <= apart; });
    if (between_multiples(energy, k, apart) && !taken && energy[k] > energy[best]) best = k;
  }
  return best;
}

double order_of_line(const HannEnergy& energy, int k) {
  const auto height = [&](int j) { return std::log(std::max(energy[j], 1e-300)); };
  const double left = height(k - 1), middle = height(k), right = height(k + 1),
               bend = left - 2 * middle + right;
  const double shift = bend < 0 ? std::clamp((left - right) / (2 * bend), -0.5, 0.5) : 0;
  return (k + shift) / energy.turns();
}

}  // namespace rubsweep::diagnose::features
