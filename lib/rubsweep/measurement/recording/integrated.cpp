#include "rubsweep/measurement/recording/integrated.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

namespace rubsweep::recording {
namespace {

/// Weights, in 1440ths, of six readings for the integral from the first to the second of them, from the
/// second to the third, and from the third to the fourth.
constexpr std::array<std::array<double, 6>, 3> weights_of_steps{
    {{475, 1427, -798, 482, -173, 27}, {-27, 637, 1022, -258, 77, -11}, {11, -93, 802, 802, -93, 11}}};

/// Replaces a stretch without gaps by its integral from the first reading on.
void integrate(std::span<double> stretch, double step_s) {
  const std::vector<double> readings(stretch.begin(), stretch.end());
  const std::size_t last_first = readings.size() - 6;
  stretch[0] = 0;
  for (std::size_t k = 0; k + 1 < readings.size(); ++k) {
    const std::size_t first = std::min(k < 2 ? 0 : k - 2, last_first), place = k - first;
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i)
      sum += weights_of_steps[std::min(place, 4 - place)][place > 2 ? 5 - i : i] * readings[first + i];
    stretch[k + 1] = stretch[k] + sum * step_s / 1440;
  }
}

void subtract_mean(std::span<double> stretch) {
  double mean = 0;
  for (const double value : stretch) mean += value / static_cast<double>(stretch.size());
  for (double& value : stretch) value -= mean;
}

/// Polynomial fitted in the window of so many readings about a place, as coefficients of powers of the
/// distance in half windows.
Eigen::VectorXd polynomial_about(std::span<const double> stretch, double middle, double window, int degree) {
  const double half = window / 2;
  std::array<double, 5> moments{};
  std::array<double, 3> sides{};
  const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(middle - half)));
  for (std::size_t k = first; k < stretch.size() && static_cast<double>(k) <= middle + half; ++k) {
    const double off = (static_cast<double>(k) - middle) / half;
    const double cosine = std::cos(std::numbers::pi / 2 * off), square = cosine * cosine;
    double weighted = square * square;
    for (std::size_t power = 0; power < moments.size(); ++power) {
      moments[power] += weighted;
      if (power < sides.size()) sides[power] += weighted * stretch[k];
      weighted *= off;
    }
  }
  Eigen::MatrixXd squares(degree + 1, degree + 1);
  for (int row = 0; row <= degree; ++row)
    for (int column = 0; column <= degree; ++column)
      squares(row, column) = moments[static_cast<std::size_t>(row + column)];
  return squares.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(sides.data(), degree + 1));
}

/// Subtracts the slow part of a stretch. It is computed at places a fraction of the window apart, and is the
/// cubic through four of them in between.
void subtract_slow_part(std::span<double> stretch, double window, int degree) {
  constexpr double places_a_window = 48;
  const auto last = static_cast<double>(stretch.size() - 1);
  window = std::min(window, last + 2);
  const auto places = static_cast<std::ptrdiff_t>(std::max(3.0, std::ceil(last / window * places_a_window)));
  const double step = last / static_cast<double>(places);
  std::vector<double> slow;
  for (std::ptrdiff_t i = 0; i <= places; ++i) {
    const double place = step * static_cast<double>(i);
    const double middle =
        std::clamp(place, std::min(window / 2 - 1, last / 2), std::max(last - window / 2 + 1, last / 2));
    // The windows at both ends stay within the readings, so that their polynomials hold for many places.
    const Eigen::VectorXd polynomial = polynomial_about(stretch, middle, window, degree);
    double value = 0;
    for (int power = degree; power >= 0; --power)
      value = value * (place - middle) / (window / 2) + polynomial(power);
    slow.push_back(value);
  }
  for (std::size_t k = 0; k < stretch.size(); ++k) {
    const double place = static_cast<double>(k) / step;
    const std::ptrdiff_t first =
        std::clamp(static_cast<std::ptrdiff_t>(place) - 1, std::ptrdiff_t{0}, places - 3);
    const double u = place - static_cast<double>(first);
    const auto at = [&](std::ptrdiff_t i) { return slow[static_cast<std::size_t>(first + i)]; };
    stretch[k] -= -at(0) * (u - 1) * (u - 2) * (u - 3) / 6 + at(1) * u * (u - 2) * (u - 3) / 2 -
                  at(2) * u * (u - 1) * (u - 3) / 2 + at(3) * u * (u - 1) * (u - 2) / 6;
  }
}

}  // namespace

std::vector<double> integrated(std::span<const double> readings, double rate_hz, int times, double window_s) {
  std::vector<double> values(readings.begin(), readings.end());
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end + 1) {
    end = begin;
    while (end < values.size() && std::isfinite(values[end])) ++end;
    const std::span<double> stretch = std::span(values).subspan(begin, end - begin);
    if (stretch.size() < fewest_integrated) {
      std::ranges::fill(stretch, NAN);
      continue;
    }
    subtract_mean(stretch);
    for (int i = 0; i < times; ++i) {
      integrate(stretch, 1 / rate_hz);
      subtract_mean(stretch);
    }
    subtract_slow_part(stretch, window_s * rate_hz, times);
  }
  return values;
}

}  // namespace rubsweep::recording
