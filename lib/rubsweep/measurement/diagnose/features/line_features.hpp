#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::features {

/// A number that describes a motion. It does not change when the motion is scaled, recorded from another mark
/// on the shaft or, with two probes, rotated.
struct Feature {
  std::string name;
  double value = 0;
};
using Features = std::vector<Feature>;

void add(Features& features, std::string name, double value);

/// Energy of every line after a Hann window, as a share of the whole energy. With the window, energy that
/// lies between two lines stays close to them. Line k has order k / turns(). `plane`: true with two probes;
/// with one probe the motion is real, and only lines of order 0 and above are used.
class HannEnergy {
 public:
  HannEnergy(const MotionLines& lines, bool plane);

  int first() const { return first_; }
  int last() const { return last_; }
  int turns() const { return turns_; }
  double operator[](int k) const { return k < first_ || k > last_ ? 0 : share_[index(k)]; }

  double near(double order, int bins) const;  ///< Energy of the lines within `bins` bins of an order.

 private:
  std::size_t index(int k) const { return static_cast<std::size_t>(std::ptrdiff_t{k} + last_); }
  int turns_, last_, first_;
  std::vector<double> share_;
};

/// Whether line k is more than `bins` bins away from every multiple of the shaft speed, including 0X.
bool between_multiples(const HannEnergy& energy, int k, int bins);

/// Number of the strongest line more than two bins away from the multiples of the shaft speed and from
/// `others`; 0 where there is none.
int strongest_between_multiples(const HannEnergy& energy, const std::vector<int>& others);

/// Order of a line, interpolated: maximum of the parabola through the logarithms of its energy and its
/// neighbours'.
double order_of_line(const HannEnergy& energy, int k);

/// Straightness of the motion of two probes about its mean, |mean of z^2| / mean of |z|^2: 1 where it stays
/// on one straight line, 0 on circles. The force of a flat stop keeps its direction, and so does the motion
/// that it causes on equal supports; in a round stop the force turns. Line k is multiplied by `weight(k)`,
/// which is the same for -k.
template <class Weight>
double straightness(const MotionLines& lines, Weight weight) {
  std::complex<double> squares = 0;
  double all = 0;
  for (int k = 1; k <= lines.last(); ++k) {
    const double squared = std::pow(weight(k), 2);
    squares += squared * 2 * lines.at(k) * lines.at(-k);
    all += squared * (std::norm(lines.at(k)) + std::norm(lines.at(-k)));
  }
  return all > 0 ? std::abs(squares) / all : 0;
}

/// Features of the full spectrum, as decimal logarithms of shares of the energy: at multiples of the shaft
/// speed (forward and backward), at its fractions 1/2 to 1/5, at other orders, in the strongest of these
/// lines with its sidebands, and in the noise between the lines; with two probes also its straightness.
/// `plane`: true with two probes; with one probe the motion is real.
Features line_features(const MotionLines& lines, bool plane);

}  // namespace rubsweep::diagnose::features
