#pragma once

#include <cmath>
#include <random>

namespace rubsweep::contact {

/// Draws random contacts and states over many orders of magnitude, the same in every run.
class RandomContact {
 public:
  explicit RandomContact(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  double either_sign(double magnitude) { return uniform(0, 1) < 0.5 ? -magnitude : magnitude; }

  double stiffness() { return log_uniform(1e3, 1e9); }
  double damping() { return log_uniform(1e-1, 1e6); }
  double penetration() { return either_sign(log_uniform(1e-12, 1e-2)); }
  double speed() { return either_sign(log_uniform(1e-9, 1e2)); }

 private:
  std::mt19937_64 random_;
};

}  // namespace rubsweep::contact
