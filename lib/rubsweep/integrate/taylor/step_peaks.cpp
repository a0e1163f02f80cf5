#include "rubsweep/integrate/taylor/step_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/numerics/cubic_maximum.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr double piece_times_fastest = 0.25;  ///< cubics through values and rates have peaks to 2e-5
constexpr int most_pieces = 64;

/// So many that a cubic through values and rates at the ends of a piece has its maximum.
int pieces_of(double fastest, double duration_rad) {
  return std::clamp(static_cast<int>(std::ceil(duration_rad * fastest / piece_times_fastest)), 1,
                    most_pieces);
}

/// Square of the distance |map q|, from the states at both ends of a piece.
template <class Map, class State>
double largest_square(const Map& map, const State& from, const State& to, double duration_rad) {
  const Eigen::Index n = map.cols();
  const Eigen::Vector2d a = map * from.head(n), a_rate = map * from.tail(n), b = map * to.head(n),
                        b_rate = map * to.tail(n);
  return numerics::cubic_maximum(a.squaredNorm(), 2 * duration_rad * a.dot(a_rate), b.squaredNorm(),
                                 2 * duration_rad * b.dot(b_rate));
}

/// Of what has the value and the rate that `at` gives.
template <class At>
double largest_of(const At& at, double fastest, double duration_rad) {
  const int pieces = pieces_of(fastest, duration_rad);
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
LargestDisplacements largest_displacements(const Expansion<N>& motion, const run::ScaledSystem<N>& system,
                                           double fastest, double duration_rad, std::vector<double>& probe,
                                           std::vector<double>& other) {
  using State = Eigen::Map<const Eigen::VectorXd>;
  const Eigen::Index n = system.coordinates();
  const int pieces = pieces_of(fastest, duration_rad);
  const double size = duration_rad / pieces;
  std::vector<double>*last = &probe, *next = &other;
  motion.put_state(0, last->data());
  LargestDisplacements square;
  for (int i = 1; i <= pieces; ++i) {
    motion.put_state(size * i, next->data());
    const State from(last->data(), 2 * n), to(next->data(), 2 * n);
    square.observed = std::max(square.observed, largest_square(system.observed, from, to, size));
    for (const run::ScaledCasing<N>& casing : system.casings)
      square.casing = std::max(square.casing, largest_square(casing.map, from, to, size));
    std::swap(last, next);
  }
  return {std::sqrt(square.observed), std::sqrt(square.casing)};
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

template LargestDisplacements largest_displacements<2>(const Expansion<2>&, const run::ScaledSystem<2>&,
                                                       double, double, std::vector<double>&,
                                                       std::vector<double>&);
template LargestDisplacements largest_displacements<4>(const Expansion<4>&, const run::ScaledSystem<4>&,
                                                       double, double, std::vector<double>&,
                                                       std::vector<double>&);
template LargestDisplacements largest_displacements<6>(const Expansion<6>&, const run::ScaledSystem<6>&,
                                                       double, double, std::vector<double>&,
                                                       std::vector<double>&);
template LargestDisplacements largest_displacements<Eigen::Dynamic>(const Expansion<Eigen::Dynamic>&,
                                                                    const run::ScaledSystem<Eigen::Dynamic>&,
                                                                    double, double, std::vector<double>&,
                                                                    std::vector<double>&);

}  // namespace rubsweep::integrate::taylor
