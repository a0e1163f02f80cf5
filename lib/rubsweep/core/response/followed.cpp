#include "rubsweep/core/response/followed.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "rubsweep/core/response/closest_return.hpp"
#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

namespace rubsweep::response {
namespace {

using Complex = std::complex<double>;

/// Displacements of the observed point at `count` successive rows.
std::vector<Complex> displacements(std::span<const double> rows, std::size_t states,
                                   const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed) {
  std::vector<Complex> z;
  for (std::size_t first = 0; first < rows.size(); first += states) {
    const Eigen::Map<const Eigen::VectorXd> q(rows.data() + first, observed.cols());
    z.emplace_back(observed.row(0).dot(q), observed.row(1).dot(q));
  }
  return z;
}

bool stays_away(const ClosestReturn& nearest, double known_rate) {
  return nearest.distance >= significant_return && nearest.rate_error_bar <= known_rate &&
         std::abs(nearest.rate) <= std::max(nearest.rate_error_bar, zero_rate);
}

/// A motion that grows without an end, such as that of a resonance with next to no damping, passes for a
/// torus otherwise: no disturbance of it grows by any rate.
bool stays_as_large(std::span<const double> rows) {
  const auto square = [](std::span<const double> part) {
    return Eigen::Map<const Eigen::VectorXd>(part.data(), static_cast<Eigen::Index>(part.size()))
        .squaredNorm();
  };
  const double before = square(rows.first(rows.size() / 2)), after = square(rows.last(rows.size() / 2));
  return std::abs(after - before) <= steady_share * before;
}

/// Mean distance of sections, every fourth of which is looked at, from the nearest one of `cloud`.
double mean_distance(std::span<const double> sections, std::span<const double> cloud, std::size_t states) {
  double sum = 0;
  int looks = 0;
  for (std::size_t i = 0; i < sections.size(); i += 4 * states, ++looks) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < cloud.size(); j += states) {
      double square = 0;
      for (std::size_t k = 0; k < states; ++k)
        square += (sections[i + k] - cloud[j + k]) * (sections[i + k] - cloud[j + k]);
      nearest = std::min(nearest, square);
    }
    sum += std::sqrt(nearest);
  }
  return sum / looks;
}

}  // namespace

void Followed::add(std::span<const double> section, double contribution, bool touched) {
  rows.insert(rows.end(), section.begin(), section.end());
  contributions.push_back(contribution);
  turns_without_contact = touched ? 0 : turns_without_contact + 1;
}

bool returns_like_a_torus(const Followed& motion, const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed,
                          int window, double known_rate, spectrum::SpectrumWorkspace& workspace) {
  const std::size_t half = 2 * motion.turns() / 5;
  const auto rows = motion.last_rows(2 * half);
  if (!stays_away(closest_return(rows, static_cast<int>(motion.states), window / 2), known_rate))
    return false;
  if (!stays_as_large(rows)) return false;
  const std::vector<Complex> z = displacements(rows, motion.states, observed);
  return spectrum::same_discrete_lines(std::span(z).first(half), std::span(z).last(half), workspace);
}

bool belongs_to(const Followed& motion, std::span<const double> sections) {
  constexpr double more = 4, small = 0.01;  // the second in clearances
  if (4 * motion.turns() * motion.states < 15 * sections.size()) return true;
  const auto rows = motion.last_rows(4 * motion.turns() / 5);
  const auto cloud = rows.first(rows.size() - sections.size());
  const double usual = mean_distance(rows.last(sections.size()), cloud, motion.states);
  return mean_distance(sections, cloud, motion.states) <= std::max(more * usual, small);
}

}  // namespace rubsweep::response
