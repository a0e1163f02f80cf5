#include "rubsweep/recording/mark_fit.hpp"

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

/// Polynomial through the marks about mark i, at a place that counts turns.
double between_marks(std::span<const double> marks_s, std::span<const double> turns, std::size_t i,
                     double place) {
  const std::size_t begin =
      std::min(i - std::min(i, std::size_t{2}), marks_s.size() - std::min<std::size_t>(marks_s.size(), 4));
  const std::size_t end = std::min(begin + 4, marks_s.size());
  double sum = 0;
  for (std::size_t a = begin; a < end; ++a) {
    double weight = 1;
    for (std::size_t b = begin; b < end; ++b)
      if (b != a) weight *= (place - turns[b]) / (turns[a] - turns[b]);
    sum += weight * marks_s[a];
  }
  return sum;
}

/// Median of up to eight intervals about mark i, without that before it.
double usual_interval_s(std::span<const double> marks_s, std::size_t i) {
  std::vector<double> intervals_s;
  for (std::size_t k = std::max<std::size_t>(i, 5) - 4; k <= i + 4 && k < marks_s.size(); ++k)
    if (k != i) intervals_s.push_back(marks_s[k] - marks_s[k - 1]);
  if (intervals_s.empty()) return 0;
  const auto middle = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
  std::ranges::nth_element(intervals_s, middle);
  return *middle;
}

/// Turns from one mark to the next by those beside them: more than one only where the number is clear.
double turns_between(std::span<const double> marks_s, std::size_t i) {
  const double usual_s = usual_interval_s(marks_s, i);
  if (usual_s == 0) return 1;
  const double turns = (marks_s[i] - marks_s[i - 1]) / usual_s, whole = std::round(turns);
  return whole >= 2 && std::abs(turns - whole) < 0.1 ? whole : 1;
}

/// Whether mark i cuts what is one turn, from `before_s` to the next mark, into two parts.
bool cuts_a_turn(std::span<const double> marks_s, std::size_t i, double before_s) {
  if (i + 1 >= marks_s.size()) return false;
  const double usual_s = usual_interval_s(marks_s, i);
  return marks_s[i] - before_s < 0.9 * usual_s &&
         std::abs(marks_s[i + 1] - before_s - usual_s) < 0.1 * usual_s;
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

TurnMarks numbered_marks(std::span<const double> marks_s) {
  TurnMarks numbered;
  std::vector<double> kept;
  for (std::size_t i = 0; i < marks_s.size(); ++i) {
    if (!kept.empty() && cuts_a_turn(marks_s, i, kept.back())) {
      ++numbered.dropped;
    } else {
      kept.push_back(marks_s[i]);
    }
  }
  std::vector<double> turns(kept.size(), 0);
  for (std::size_t i = 1; i < kept.size(); ++i) turns[i] = turns[i - 1] + turns_between(kept, i);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (double turn = i > 0 ? turns[i - 1] + 1 : turns[i]; turn < turns[i]; ++turn) {
      numbered.t_s.push_back(between_marks(kept, turns, i, turn));
      ++numbered.filled;
    }
    numbered.t_s.push_back(kept[i]);
  }
  return numbered;
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
