#include "rubsweep/measurement/recording/mark_fit.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace rubsweep::recording {
namespace {

/// Shares of the signal's range outside of which a sample stands on a level and not on an edge.
constexpr double level_share = 0.1;
constexpr double half_resolved = 0.2;

/// Values of the four cubic B-splines of unit pieces at 0 <= u <= 1 of a piece.
std::array<double, 4> cubic_splines(double u) {
  const double v = 1 - u;
  return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6,
          u * u * u / 6};
}

using Base = Eigen::SparseMatrix<double>;

/// Values of Legendre's polynomials up to a degree at equal places.
Base polynomials(Eigen::Index count, int degree) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double x = 2 * static_cast<double>(k) / static_cast<double>(count - 1) - 1;
    for (int i = 0; i <= degree; ++i)
      entries.emplace_back(static_cast<int>(k), i, std::legendre(static_cast<unsigned>(i), x));
  }
  Base base(count, degree + 1);
  base.setFromTriplets(entries.begin(), entries.end());
  return base;
}

/// Values of the B-splines of so many equal pieces at equal places.
Base splines(Eigen::Index count, Eigen::Index pieces) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double place = static_cast<double>(k * pieces) / static_cast<double>(count - 1);
    const Eigen::Index piece = std::min(static_cast<Eigen::Index>(place), pieces - 1);
    const auto values = cubic_splines(place - static_cast<double>(piece));
    for (Eigen::Index i = 0; i < 4; ++i)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(piece + i),
                           values[static_cast<std::size_t>(i)]);
  }
  Base base(count, pieces + 3);
  base.setFromTriplets(entries.begin(), entries.end());
  return base;
}

/// Values of the curve that is nowhere farther than `bound` from the given ones, or comes as near to that as
/// found: least squares, whose weights then grow where the distance is large (C. L. Lawson 1961). Rounding is
/// bounded and far from normal, and the bounds of many marks leave a smooth curve far less room than their
/// mean square does.
std::optional<Eigen::VectorXd> within(const Base& base, const Eigen::VectorXd& values, double bound) {
  constexpr int most_rounds = 80;
  constexpr double hopeless = 4;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(values.size()), best;
  double smallest = hopeless * bound;
  for (int round = 0; round < most_rounds; ++round) {
    const Base weighted = weights.asDiagonal() * base;
    const Eigen::SimplicialLDLT<Base> normal(base.transpose() * weighted);
    const Eigen::VectorXd fit = base * normal.solve(weighted.transpose() * values);
    const Eigen::VectorXd left = (values - fit).cwiseAbs();
    const double largest = left.maxCoeff();
    if (round == 0 && !(largest < smallest)) return std::nullopt;
    if (largest < smallest) {
      smallest = largest;
      best = fit;
    }
    weights = (weights.array() * left.array() + 1e-12 * bound).matrix();
    weights *= static_cast<double>(values.size()) / weights.sum();
  }
  if (smallest > bound) return std::nullopt;
  return best;
}

}  // namespace

double mark_resolution(std::span<const double> signal, Mark mark, double threshold) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : signal) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  const double margin = level_share * (high - low);
  const auto on_edge = [&](double value) { return value > low + margin && value < high - margin; };
  std::array<std::size_t, 3> edges{};
  for (std::size_t k = 1; k < signal.size(); ++k) {
    const bool before = signal[k - 1] > threshold, now = signal[k] > threshold;
    if (before == now || now != (mark == Mark::bright)) continue;
    ++edges[static_cast<std::size_t>(on_edge(signal[k - 1])) + static_cast<std::size_t>(on_edge(signal[k]))];
  }
  // The coarser half counts.
  const std::size_t half = (edges[0] + edges[1] + edges[2]) / 2;
  if (edges[0] > half) return 1;
  return edges[0] + edges[1] > half ? half_resolved : 0;
}

SmoothMarks smoothed_marks(std::span<const double> marks_s, double resolution_s) {
  const auto count = static_cast<Eigen::Index>(marks_s.size());
  SmoothMarks smooth{.t_s = {marks_s.begin(), marks_s.end()}};
  if (resolution_s == 0) return smooth;
  // About the first mark and in units of a mark's room: long recordings keep their digits.
  const Eigen::VectorXd marks =
      (Eigen::Map<const Eigen::VectorXd>(marks_s.data(), count).array() - marks_s.front()) / resolution_s;
  // The first curve within the bounds may lie at them all along: the next one, which holds it, is nearer to
  // the truth.
  std::optional<Eigen::VectorXd> fit;
  bool held = false;
  const auto take = [&](const Base& base) {
    held = fit.has_value();
    if (auto next = within(base, marks, smoothing_bound)) {
      fit = std::move(next);
      smooth.degree = static_cast<int>(base.cols()) - 1;
    }
  };
  for (int degree = 1; degree <= 5 && count >= 4 * degree && !(fit && held); ++degree)
    take(polynomials(count, degree));
  constexpr Eigen::Index marks_a_piece = 4;
  for (Eigen::Index pieces = 2; count >= marks_a_piece * pieces && !(fit && held); pieces *= 2)
    take(splines(count, pieces));
  if (!fit) return smooth;
  for (Eigen::Index k = 0; k < count; ++k)
    smooth.t_s[static_cast<std::size_t>(k)] = marks_s.front() + resolution_s * (*fit)(k);
  return smooth;
}

}  // namespace rubsweep::recording
