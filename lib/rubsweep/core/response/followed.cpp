#include "rubsweep/core/response/followed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <complex>
#include <limits>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

namespace rubsweep::response {
namespace {

constexpr std::size_t trend_blocks = 8;

/// Squared distance of each row from the row `order` turns later.
void square_distances(std::span<const double> rows, std::size_t width, std::size_t order,
                      std::vector<double>& squares) {
  squares.clear();
  const std::size_t lag = order * width;
  for (std::size_t first = 0; first + lag < rows.size(); first += width) {
    double square = 0;
    for (std::size_t i = first; i < first + width; ++i) {
      square += (rows[i + lag] - rows[i]) * (rows[i + lag] - rows[i]);
    }
    squares.push_back(square);
  }
}

double mean(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Slope of ln distance per turn, with its error bar.
void fit_rate(std::span<const double> squares, ClosestReturn& result) {
  const std::size_t length = squares.size() / trend_blocks;
  const auto kept = squares.last(trend_blocks * length);
  std::vector<double> places, logs;
  for (std::size_t b = 0; b < trend_blocks; ++b) {
    places.push_back(static_cast<double>(b) - (trend_blocks - 1) / 2.0);
    logs.push_back(std::log(mean(kept.subspan(b * length, length))) / 2);
  }
  const auto [level, slope] = boost::math::statistics::simple_ordinary_least_squares(places, logs);
  double residual = 0, spread = 0;
  for (std::size_t b = 0; b < trend_blocks; ++b) {
    const double error = logs[b] - level - slope * places[b];
    residual += error * error / (trend_blocks - 2);
    spread += places[b] * places[b];
  }
  result.rate = slope / static_cast<double>(length);
  result.rate_error_bar =
      student_quantile(trend_blocks - 2) * std::sqrt(residual / spread) / static_cast<double>(length);
}

using Complex = std::complex<double>;

/// Displacements (x, y) of the observed point in successive rows, as complex numbers.
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

/// Whether the size of the motion stays constant. A motion that grows for ever, such as an almost undamped
/// resonance, would otherwise count as a torus, because no disturbance of it grows.
bool stays_as_large(std::span<const double> rows) {
  const auto square = [](std::span<const double> part) {
    return Eigen::Map<const Eigen::VectorXd>(part.data(), static_cast<Eigen::Index>(part.size()))
        .squaredNorm();
  };
  const double before = square(rows.first(rows.size() / 2)), after = square(rows.last(rows.size() / 2));
  return std::abs(after - before) <= steady_share * before;
}

/// Mean distance of every fourth section from its nearest neighbour in `cloud`.
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

ClosestReturn closest_return(std::span<const double> rows, int states, int max_order) {
  const auto width = static_cast<std::size_t>(states);
  if (states < 1 || max_order < 1 || rows.size() % width != 0 ||
      rows.size() / width < static_cast<std::size_t>(max_order) + 2 * trend_blocks + 1) {
    throw SolverError(fmt::format("{} numbers are no section of {} states for returns up to {} turns",
                                  rows.size(), states, max_order));
  }
  ClosestReturn result;
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<double> squares, nearest;
  for (int n = 1; n <= max_order; ++n) {
    square_distances(rows, width, static_cast<std::size_t>(n), squares);
    const double square = mean(squares);
    if (!(square < smallest)) continue;
    smallest = square;
    result.order = n;
    nearest.swap(squares);
  }
  result.distance = std::sqrt(smallest);
  fit_rate(nearest, result);
  return result;
}

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
  constexpr double more = 4, small = 0.01;  // `more`: ratio; `small`: clearances
  if (4 * motion.turns() * motion.states < 15 * sections.size()) return true;
  const auto rows = motion.last_rows(4 * motion.turns() / 5);
  const auto cloud = rows.first(rows.size() - sections.size());
  const double usual = mean_distance(rows.last(sections.size()), cloud, motion.states);
  return mean_distance(sections, cloud, motion.states) <= std::max(more * usual, small);
}

}  // namespace rubsweep::response
