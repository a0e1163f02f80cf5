#include "rubsweep/measurement/fit/first_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/fit/uncertainty.hpp"

namespace rubsweep::fit {
namespace {

/// Sum of squares at these parameter values; infinite where the values are impossible.
double left_at(const LeastSquares& squares, const Eigen::VectorXd& values) {
  try {
    return squares.residuals(values).squaredNorm();
  } catch (const ConfigError&) {
    return INFINITY;
  } catch (const SolverError&) {
    return INFINITY;
  }
}

bool has_rubs(const MachineFit& problem) {
  return std::ranges::any_of(
      problem.data, [](const MeasuredData& data) { return std::holds_alternative<RubLines>(data.data); });
}

/// Tries each angle at 24 places of a turn within its bounds and keeps the place with the smallest sum of
/// squares; goes through the angles twice. A descent that starts a quarter turn off may end in a wrong
/// minimum. With orbits of rubs, only the angle of the mark is tried: other angles change the motion.
void turn_angles(const MachineFit& problem, const LeastSquares& squares, Eigen::VectorXd& start) {
  constexpr int rounds = 2, places = 24;
  constexpr double turn_deg = 360;
  const bool rubs = has_rubs(problem);
  double least = left_at(squares, start);
  for (int round = 0; round < rounds; ++round) {
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      const Parameter& angle = problem.parameters[static_cast<std::size_t>(i)];
      if (angle.name != mark_name && (rubs || !angle.name.ends_with("_deg"))) continue;
      Eigen::VectorXd turned = start;
      const double from = start(i);
      for (int k = 1; k < places; ++k) {
        turned(i) = from + k * turn_deg / places;
        while (turned(i) >= angle.high) turned(i) -= turn_deg;
        if (turned(i) <= angle.low) continue;
        const double left = left_at(squares, turned);
        if (left >= least) continue;
        least = left;
        start(i) = turned(i);
      }
    }
  }
}

/// Shortest period of the strongest line in the sensors' ring-downs; infinite without ring-downs.
double ringing_period_s(const MachineFit& problem) {
  double shortest_s = INFINITY;
  for (const MeasuredData& data : problem.data) {
    const auto* ring = std::get_if<RingDown>(&data.data);
    if (ring == nullptr) continue;
    const double step_s = (ring->t_s.back() - ring->t_s.front()) / static_cast<double>(ring->t_s.size() - 1);
    for (Eigen::Index i = 0; i < ring->signal_m.cols(); ++i) {
      const Eigen::VectorXd signal = ring->signal_m.col(i);
      const double line = test_residuals({signal.data(), static_cast<std::size_t>(signal.size())}).line;
      if (line > 0) shortest_s = std::min(shortest_s, step_s / line);
    }
  }
  return shortest_s;
}

/// Candidates for the instant of the hit between its bounds, at least a sixth of a period apart, sorted by
/// ascending sum of squares. The sum of squares has a minimum in every half period of the vibration.
std::vector<double> places_of_hit(const MachineFit& problem, const LeastSquares& squares,
                                  const Eigen::VectorXd& start, Eigen::Index hit) {
  constexpr double share_of_period = 6;
  constexpr int most_places = 240;
  const Parameter& parameter = problem.parameters[static_cast<std::size_t>(hit)];
  const double period_s = ringing_period_s(problem), range_s = parameter.high - parameter.low;
  if (!std::isfinite(period_s)) return {};
  const int places =
      static_cast<int>(std::clamp(std::ceil(share_of_period * range_s / period_s), 2.0, 1.0 * most_places));
  std::vector<std::pair<double, double>> left;
  for (int k = 0; k < places; ++k) {
    Eigen::VectorXd at = start;
    at(hit) = parameter.low + (k + 0.5) / places * range_s;
    left.emplace_back(left_at(squares, at), at(hit));
  }
  std::ranges::sort(left);
  std::vector<double> found;
  for (const auto& [square, place] : left)
    if (square < INFINITY) found.push_back(place);
  return found;
}

/// Sets the instant of the hit in the start values, if it is a parameter of a ring-down: short descents start
/// at many instants, and the best one is kept. In the first round the other parameters are still wrong, so a
/// second round repeats the search with their improved values.
void find_hit(const MachineFit& problem, LeastSquares squares, const LeastSquaresOptions& options,
              Eigen::VectorXd& start) {
  const auto named = std::ranges::find(problem.parameters, hit_name, &Parameter::name);
  if (named == problem.parameters.end()) return;
  const auto hit = static_cast<Eigen::Index>(named - problem.parameters.begin());
  const LeastSquaresOptions brief{.most_iterations = 12, .stop = options.stop};
  double least = INFINITY;
  for (const std::size_t descents : {8u, 3u}) {
    std::vector<double> places = places_of_hit(problem, squares, start, hit);
    if (has_rubs(problem)) {
      // A rub must be followed in small steps: descents from distant points would not find it again.
      if (places.empty()) return;
      Eigen::VectorXd moved = start;
      moved(hit) = places.front();
      if (left_at(squares, moved) < left_at(squares, start)) start = moved;
      return;
    }
    places.resize(std::min(places.size(), descents));
    if (least == INFINITY) places.push_back(start(hit));
    const Eigen::VectorXd others = start;
    for (const double place : places) {
      Eigen::VectorXd from = others;
      from(hit) = place;
      begin_at(from, squares);
      const LeastSquaresFit fit = least_squares(squares, brief);
      if (fit.stopped) return;
      if (fit.value.size() == 0 || !(fit.cost < least)) continue;
      least = fit.cost;
      start = fit.value;
    }
  }
}

}  // namespace

void begin_at(const Eigen::VectorXd& start, LeastSquares& squares) {
  for (Eigen::Index i = 0; i < start.size(); ++i)
    squares.parameters[static_cast<std::size_t>(i)].start = start(i);
}

void find_first_values(const MachineFit& problem, const LeastSquares& squares,
                       const LeastSquaresOptions& options, Eigen::VectorXd& start) {
  turn_angles(problem, squares, start);
  find_hit(problem, squares, options, start);
}

}  // namespace rubsweep::fit
