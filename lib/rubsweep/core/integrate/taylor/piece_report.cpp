#include "rubsweep/core/integrate/taylor/piece_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/core/numerics/cubic_maximum.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr double piece_times_fastest = 0.25;  ///< cubics through values and rates then give peaks to 2e-5
constexpr int most_pieces = most_peak_states - 1;

/// Number of pieces for which cubics through values and rates at their ends give the maximum.
int pieces_of(double fastest, double duration_rad) {
  return std::clamp(static_cast<int>(std::ceil(duration_rad * fastest / piece_times_fastest)), 1,
                    most_pieces);
}

/// Largest square of the distance |map q| by the states at both ends of a piece, at least `known`.
template <class Map, class State>
double largest_square(double known, const Map& map, const State& from, const State& to, double duration_rad) {
  const Eigen::Index n = map.cols();
  const Eigen::Vector2d a = map * from.head(n), a_rate = map * from.tail(n), b = map * to.head(n),
                        b_rate = map * to.tail(n);
  return numerics::larger_maximum(known, a.squaredNorm(), 2 * duration_rad * a.dot(a_rate), b.squaredNorm(),
                                  2 * duration_rad * b.dot(b_rate));
}

}  // namespace

template <int N>
LargestDisplacements largest_displacements(const Expansion<N>& motion, const run::ScaledSystem<N>& system,
                                           double fastest, double duration_rad, std::vector<double>& states) {
  using State = Eigen::Map<const Eigen::VectorXd>;
  const Eigen::Index numbers = 2 * system.coordinates();
  const int pieces = pieces_of(fastest, duration_rad);
  const double size = duration_rad / pieces;
  states.resize(static_cast<std::size_t>(most_peak_states * numbers));
  motion.series().put_states(
      pieces + 1, [size](int i) { return size * i; }, states.data());
  LargestDisplacements square;
  for (int i = 0; i < pieces; ++i) {
    const double* const start = states.data() + i * numbers;
    const State from(start, numbers), to(start + numbers, numbers);
    square.observed = largest_square(square.observed, system.observed, from, to, size);
    for (const run::ScaledCasing<N>& casing : system.casings)
      square.casing = largest_square(square.casing, casing.map, from, to, size);
  }
  return {std::sqrt(square.observed), std::sqrt(square.casing)};
}

double largest_force(const ContactSeries& contact, int order, double fastest, double duration_rad) {
  using numerics::both, numerics::Twin;
  const double spring = contact.law().spring(contact.mode()), damper = contact.law().damper(contact.mode());
  std::array<double, numerics::most_taylor_order> force;
  for (int k = 0; k < order; ++k)
    force[static_cast<std::size_t>(k)] =
        spring * contact.penetration_term(k) + damper * (k + 1) * contact.penetration_term(k + 1);
  const int pieces = pieces_of(fastest, duration_rad);
  const double size = duration_rad / pieces;
  const double start = force[0], start_rate = order > 1 ? force[1] : 0;
  double largest = start, last = start, last_rate = start_rate;
  const auto next = [&](double value, double rate) {
    largest = numerics::larger_maximum(largest, last, size * last_rate, value, size * rate);
    last = value;
    last_rate = rate;
  };
  // Four ends of pieces at a time, so that their sums do not wait for each other.
  for (int i = 1; i <= pieces; i += 4) {
    const Twin at[2] = {Twin{size * i, size * (i + 1)}, Twin{size * (i + 2), size * (i + 3)}};
    Twin value[2]{}, rate[2]{};
    for (auto k = static_cast<std::size_t>(order); k-- > 0;) {
      for (int pair = 0; pair < 2; ++pair) {
        rate[pair] = rate[pair] * at[pair] + value[pair];
        value[pair] = value[pair] * at[pair] + both(force[k]);
      }
    }
    for (int end = 0; end < 4 && i + end <= pieces; ++end)
      next(value[end / 2][end % 2], rate[end / 2][end % 2]);
  }
  return largest;
}

template LargestDisplacements largest_displacements<2>(const Expansion<2>&, const run::ScaledSystem<2>&,
                                                       double, double, std::vector<double>&);
template LargestDisplacements largest_displacements<4>(const Expansion<4>&, const run::ScaledSystem<4>&,
                                                       double, double, std::vector<double>&);
template LargestDisplacements largest_displacements<6>(const Expansion<6>&, const run::ScaledSystem<6>&,
                                                       double, double, std::vector<double>&);
template LargestDisplacements largest_displacements<Eigen::Dynamic>(const Expansion<Eigen::Dynamic>&,
                                                                    const run::ScaledSystem<Eigen::Dynamic>&,
                                                                    double, double, std::vector<double>&);

}  // namespace rubsweep::integrate::taylor
