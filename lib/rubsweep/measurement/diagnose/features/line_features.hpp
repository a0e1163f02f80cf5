#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::features {

/// A number that describes a motion and stays the same when the motion is turned, scaled, or recorded from
/// another mark on the shaft. Of one probe: when it is scaled, or recorded from another mark.
struct Feature {
  std::string name;
  double value = 0;
};
using Features = std::vector<Feature>;

void add(Features& features, std::string name, double value);

/// Energy of every line as a Hann window sees it, as a share of all: lines between two whole numbers of
/// periods stay together. Line k is of order k / turns(). `plane`: two probes; else the motion is real, and
/// only lines from order 0 on count.
class HannEnergy {
 public:
  HannEnergy(const MotionLines& lines, bool plane);

  int first() const { return first_; }
  int last() const { return last_; }
  int turns() const { return turns_; }
  double operator[](int k) const { return k < first_ || k > last_ ? 0 : share_[index(k)]; }

  /// Sum over the lines up to so many bins from an order.
  double near(double order, int bins) const;

 private:
  std::size_t index(int k) const { return static_cast<std::size_t>(std::ptrdiff_t{k} + last_); }
  int turns_, last_, first_;
  std::vector<double> share_;
};

/// Whether a line is more than so many bins apart from all multiples of the shaft speed, 0X included.
bool between_multiples(const HannEnergy& energy, int k, int bins);

/// The strongest line more than two bins apart from the multiples of the shaft speed and from other lines; 0
/// where there is none.
int strongest_between_multiples(const HannEnergy& energy, const std::vector<int>& others);

/// Order of a line by the parabola through the logarithms of its energy and those beside it.
double order_of_line(const HannEnergy& energy, int k);

/// Features of the full spectrum: shares of the energy at multiples of the shaft speed, forward and backward,
/// at fractions 1/2 to 1/5 of it and at its other orders, the strongest of these lines with its sidebands,
/// and the noise between the lines. Shares are decimal logarithms. `plane`: two probes; else the motion is
/// real.
Features line_features(const MotionLines& lines, bool plane);

}  // namespace rubsweep::diagnose::features
