#include "rubsweep/integrate/taylor/step_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/numerics/cubic_maximum.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr double piece_times_fastest = 0.25;  ///< cubics through values and rates have peaks to 2e-5
constexpr int most_pieces = 64;

/// Value and rate of what is watched, at the ends of so many pieces that a cubic has its maximum.
template <class At>
double largest_of(const At& at, double fastest, double duration_rad) {
  const int pieces =
      std::clamp(static_cast<int>(std::ceil(duration_rad * fastest / piece_times_fastest)), 1, most_pieces);
  const double size = duration_rad / pieces;
  auto [value, rate] = at(0.0);
  double largest = value;
  for (int i = 1; i <= pieces; ++i) {
    const auto [next, next_rate] = at(size * i);
    largest = std::max(largest, numerics::cubic_maximum(value, size * rate, next, size * next_rate));
    value = next;
    rate = next_rate;
  }
  return largest;
}

}  // namespace

template <int N>
double largest_displacement(const Expansion<N>& motion, const run::ScaledSystem<N>& system, double fastest,
                            double duration_rad, std::vector<double>& probe) {
  using Part = Eigen::Map<const Eigen::Matrix<double, N, 1>>;
  const Eigen::Index n = system.coordinates();
  const auto square = [&](double at) {
    motion.put_state(at, probe.data());
    const Eigen::Vector2d z = system.observed * Part(probe.data(), n);
    const Eigen::Vector2d v = system.observed * Part(probe.data() + n, n);
    return std::pair{z.squaredNorm(), 2 * z.dot(v)};
  };
  return std::sqrt(largest_of(square, fastest, duration_rad));
}

double largest_force(const ContactSeries& contact, int order, double fastest, double duration_rad) {
  const double spring = contact.law().spring(contact.mode()), damper = contact.law().damper(contact.mode());
  const auto force = [&](double at) {
    double value = 0, rate = 0;
    for (int k = order - 1; k >= 0; --k) {
      rate = rate * at + value;
      value = value * at + spring * contact.penetration_term(k) +
              damper * (k + 1) * contact.penetration_term(k + 1);
    }
    return std::pair{value, rate};
  };
  return largest_of(force, fastest, duration_rad);
}

template double largest_displacement<2>(const Expansion<2>&, const run::ScaledSystem<2>&, double, double,
                                        std::vector<double>&);
template double largest_displacement<4>(const Expansion<4>&, const run::ScaledSystem<4>&, double, double,
                                        std::vector<double>&);
template double largest_displacement<6>(const Expansion<6>&, const run::ScaledSystem<6>&, double, double,
                                        std::vector<double>&);
template double largest_displacement<Eigen::Dynamic>(const Expansion<Eigen::Dynamic>&,
                                                     const run::ScaledSystem<Eigen::Dynamic>&, double, double,
                                                     std::vector<double>&);

}  // namespace rubsweep::integrate::taylor
