#include "rubsweep/core/structure/free_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/split_mix.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;
using Complex = std::complex<double>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The inverse of (generator - centre) acting on states (displacement, rate / radius); coordinates are scaled
/// so that their stiffnesses are 1.
class ShiftedInverse {
 public:
  ShiftedInverse(const SpeedMatrices& matrices, const RateDisc& disc)
      : unit_(unit_of(matrices, disc.radius)),
        shift_(disc.centre / disc.radius),
        mass_(disc.radius * disc.radius * scaled(matrices.mass)),
        damping_(disc.radius * scaled(matrices.damping)),
        factors_(scaled(matrices.stiffness) + shift_ * damping_ + shift_ * shift_ * mass_) {
    if (!(factors_.reciprocal_condition() > 0))
      throw SolverError("free vibrations: one of them has the rate that others are looked for about");
    damping_ += shift_ * mass_;
  }

  Index states() const { return 2 * unit_.size(); }
  double shift() const { return shift_; }
  const Eigen::VectorXd& unit() const { return unit_; }

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& states) const {
    const Index n = unit_.size();
    Eigen::MatrixXd next(2 * n, states.cols());
    next.topRows(n) =
        -factors_.solve(Eigen::MatrixXd(damping_ * states.topRows(n) + mass_ * states.bottomRows(n)));
    next.bottomRows(n) = states.topRows(n) + shift_ * next.topRows(n);
    return next;
  }

 private:
  /// Unit of each coordinate from its stiffness, or from its mass if nothing else resists its motion.
  static Eigen::VectorXd unit_of(const SpeedMatrices& matrices, double radius) {
    const Eigen::VectorXd size = matrices.stiffness.diagonal().cwiseAbs().cwiseMax(
        radius * radius * matrices.mass.diagonal().cwiseAbs());
    return (size.array() > 0).select(size.cwiseSqrt().cwiseInverse(), 1);
  }

  Eigen::MatrixXd scaled(const Eigen::MatrixXd& matrix) const {
    return unit_.asDiagonal() * matrix * unit_.asDiagonal();
  }

  Eigen::VectorXd unit_;
  double shift_;
  Eigen::MatrixXd mass_, damping_;
  numerics::dense::LuFactors factors_;
};

/// Krylov space from two starting vectors: inverse * states.leftCols(k) = states * map, k = map.cols().
class KrylovSpace {
 public:
  explicit KrylovSpace(const ShiftedInverse& inverse) : inverse_(inverse), states_(inverse.states(), 0) {
    constexpr Index starts = 2;  // a double vibration needs two of them
    for (Index k = 0; k < starts; ++k) {
      Eigen::VectorXd start(inverse.states());
      for (Index i = 0; i < start.size(); ++i) {
        const auto state = static_cast<std::uint64_t>(k * start.size() + i);
        start(i) = std::ldexp(static_cast<double>(numerics::split_mix(state) >> 11U), -53) - 0.5;
      }
      append(start);
    }
  }

  void grow_to(Index size) {
    while (map_.cols() < size && !closed()) {
      const Index k = map_.cols();
      const Eigen::VectorXd shares = append(inverse_(states_.col(k)));
      map_.conservativeResizeLike(Eigen::MatrixXd::Zero(states_.cols(), k + 1));
      map_.col(k).head(shares.size()) = shares;
    }
  }

  /// Whether the space is invariant under the inverse.
  bool closed() const { return map_.cols() == states_.cols(); }

  Index size() const { return map_.cols(); }
  const Eigen::MatrixXd& states() const { return states_; }
  Eigen::MatrixXd square() const { return map_.topRows(map_.cols()); }
  /// Norm of the component outside the space that the inverse gives for a combination of states.
  double rest(const Eigen::VectorXcd& combination) const {
    return closed() ? 0 : (map_.bottomRows(map_.rows() - map_.cols()) * combination).norm();
  }

 private:
  /// Orthogonalises `state` against the other states and adds the remainder as a new state; returns its
  /// components along all states.
  Eigen::VectorXd append(const Eigen::VectorXd& state) {
    constexpr double nothing = 1e-14;
    Eigen::VectorXd next = state, shares = Eigen::VectorXd::Zero(states_.cols());
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough: pass 2 removes the rounding of pass 1
      const Eigen::VectorXd more = states_.transpose() * next;
      next -= states_ * more;
      shares += more;
    }
    const double rest = next.norm();
    if (!(rest > nothing * state.norm()) || states_.cols() == states_.rows()) return shares;
    states_.conservativeResize(Eigen::NoChange, states_.cols() + 1);
    states_.rightCols<1>() = next / rest;
    shares.conservativeResize(states_.cols());
    shares(shares.size() - 1) = rest;
    return shares;
  }

  const ShiftedInverse& inverse_;
  Eigen::MatrixXd states_, map_;
};

/// The vibrations of a space that lie in the disc; empty where one of them has not converged yet.
std::optional<FreeModes> settled_modes(const ShiftedInverse& inverse, const KrylovSpace& space,
                                       const RateDisc& disc) {
  constexpr double settled = 1e-13;
  const auto modes = numerics::dense::eigenvectors(space.square());
  if (!modes.values.allFinite()) throw SolverError("free vibrations: the iteration does not converge");
  std::vector<Index> found;
  for (Index j = 0; j < space.size(); ++j) {
    const double size = std::abs(modes.values(j));
    if (!(size >= 1)) continue;
    if (space.rest(modes.vectors.col(j)) > settled * size) return std::nullopt;
    found.push_back(j);
  }
  const Index n = inverse.unit().size();
  FreeModes free{Eigen::VectorXcd(found.size()), Eigen::MatrixXcd(n, found.size())};
  const auto places = space.states().topRows(n).leftCols(space.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const Eigen::VectorXcd& combination = modes.vectors.col(found[k]);
    const Eigen::VectorXd real = places * combination.real(), imaginary = places * combination.imag();
    free.rate_per_s(column) = disc.radius * (inverse.shift() + 1.0 / modes.values(found[k]));
    free.shape.col(column).real() = inverse.unit().cwiseProduct(real);
    free.shape.col(column).imag() = inverse.unit().cwiseProduct(imaginary);
    free.shape.col(column).normalize();
  }
  return free;
}

Eigen::MatrixXcd dynamic_stiffness(const SpeedMatrices& matrices, Complex rate) {
  return rate * rate * matrices.mass.cast<Complex>() + rate * matrices.damping.cast<Complex>() +
         matrices.stiffness.cast<Complex>();
}

Eigen::VectorXcd by_rate(const SpeedMatrices& matrices, Complex rate, const Eigen::VectorXcd& shape) {
  return 2.0 * rate * (matrices.mass * shape) + matrices.damping * shape;
}

}  // namespace

FreeModes free_modes(const SpeedMatrices& matrices, const RateDisc& disc) {
  constexpr Index first_states = 64;
  const ShiftedInverse inverse(matrices, disc);
  KrylovSpace space(inverse);
  for (Index states = first_states;; states += states / 2) {
    // To build most of the space step by step costs more than the whole space at once, and only the full
    // space closes.
    space.grow_to(4 * states > 3 * inverse.states() ? inverse.states() : states);
    if (auto found = settled_modes(inverse, space, disc)) return std::move(*found);
  }
}

Eigen::VectorXcd all_rates_per_s(const SpeedMatrices& matrices, double unit_per_s) {
  const ShiftedInverse inverse(matrices, {0, unit_per_s});
  const Eigen::MatrixXd whole = inverse(Eigen::MatrixXd::Identity(inverse.states(), inverse.states()));
  const Eigen::VectorXcd values = numerics::dense::eigenvalues(whole);
  if (!values.allFinite()) throw SolverError("free vibrations: the iteration does not converge");
  const double without_mass = epsilon * values.cwiseAbs().maxCoeff();
  std::vector<Complex> rates;
  for (const Complex value : values)
    if (std::abs(value) > without_mass) rates.push_back(unit_per_s / value);
  return Eigen::Map<const Eigen::VectorXcd>(rates.data(), static_cast<Index>(rates.size()));
}

bool follow_free_mode(const SpeedMatrices& matrices, Complex& rate_per_s, Eigen::VectorXcd& shape,
                      double precision) {
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXcd next =
        numerics::dense::solve(dynamic_stiffness(matrices, rate_per_s), by_rate(matrices, rate_per_s, shape));
    const Complex change = shape.squaredNorm() / shape.dot(next);
    if (!next.allFinite() || !std::isfinite(std::abs(change))) return step > 0;  // singular: this is the rate
    rate_per_s -= change;
    shape = next.normalized();
    if (std::abs(change) <= precision * std::abs(rate_per_s)) return true;
  }
  return false;
}

double rate_rounding_per_s(const SpeedMatrices& matrices, Complex rate_per_s, const Eigen::VectorXcd& shape) {
  // Left eigenvector, computed from the transposed matrices, which are regular slightly off the rate.
  const Complex beside = rate_per_s * (1 + 1e-10);
  const Eigen::MatrixXcd transposed = dynamic_stiffness(matrices, beside).transpose();
  Eigen::VectorXcd left = Eigen::VectorXcd(shape.conjugate());
  for (int step = 0; step < 2; ++step) left = numerics::dense::solve(transposed, left).normalized();
  const Eigen::VectorXd size = shape.cwiseAbs();
  const double rate = std::abs(rate_per_s);
  const Eigen::VectorXd forces = rate * rate * (matrices.mass.cwiseAbs() * size) +
                                 rate * (matrices.damping.cwiseAbs() * size) +
                                 matrices.stiffness.cwiseAbs() * size;
  const double change = std::abs((left.transpose() * by_rate(matrices, rate_per_s, shape)).value());
  // the iteration adds rounding, too, even in a rotor of two coordinates
  constexpr Index of_the_iteration = 16;
  return static_cast<double>(std::max(2 * shape.size(), of_the_iteration)) * epsilon *
         left.cwiseAbs().dot(forces) / change;
}

}  // namespace rubsweep::structure
