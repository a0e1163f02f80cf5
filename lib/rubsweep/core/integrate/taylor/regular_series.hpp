#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// State of a scaled system with an even number of coordinates as power series of a regular time s, with
/// cosine and sine of the phase; or a small change of the state, which no drive moves.
template <int N>
class RegularSeries {
 public:
  static constexpr int order = numerics::most_taylor_order;

  /// `system` must outlive this object.
  explicit RegularSeries(const run::ScaledSystem<N>& system)
      : system_(system), state_(2 * system.coordinates() + 2, order + 1), rate_(state_.rows(), order) {}

  /// Begins with u then u', and with cosine and sine of the phase; both are zero for a change.
  void begin(const double* state, numerics::Twin drive) {
    state_.col(0).head(2 * coordinates()) = Eigen::Map<const Eigen::VectorXd>(state, 2 * coordinates());
    numerics::store(&state_(2 * coordinates(), 0), drive);
    driven_ = drive[0] != 0 || drive[1] != 0;
  }

  // Coefficient k, in the two directions of a contact.
  numerics::Twin distance(const run::ScaledContact<N>& c, int k) const { return seen(c, &state_(0, k)); }
  numerics::Twin velocity(const run::ScaledContact<N>& c, int k) const {
    return seen(c, &state_(coordinates(), k));
  }
  /// Largest magnitude in coefficient k of u (`half` = 0) or u'.
  double size(int half, int k) const {
    return state_.col(k).template segment<N>(half * coordinates(), coordinates()).cwiseAbs().maxCoeff();
  }

  /// Computes coefficient k of the rates by the phase, without pulses and contacts.
  void begin_rate(int k) {
    using numerics::load, numerics::Twin;
    const Eigen::Index n = coordinates();
    const auto& system = system_;  // known to stay where it is, whatever is stored
    const bool driven = driven_, diagonal = system.diagonal;
    const double* const now = &state_(0, k);
    double* const rate = &rate_(0, k);
    const Twin drive = load(now + 2 * n), cosine = numerics::first_twice(drive),
               sine = numerics::second_twice(drive);
    for (Eigen::Index h = 0; h < n; h += 2) {
      Twin a{};
      if (driven) a = load(&system.cosine[h]) * cosine + load(&system.sine[h]) * sine;
      if (driven && k == 0) a += load(&system.constant[h]);
      if (diagonal)
        a -= load(&system.stiffness_diagonal[h]) * load(now + h) +
             load(&system.damping_diagonal[h]) * load(now + n + h);
      numerics::store(rate + h, load(now + n + h));
      numerics::store(rate + n + h, a);
    }
    numerics::store(rate + 2 * n, numerics::quarter_turned(drive));
    if (diagonal) return;
    acceleration(k).noalias() -= system.stiffness * Eigen::Map<const Vector>(now, n);
    acceleration(k).noalias() -= system.damping * Eigen::Map<const Vector>(now + n, n);
  }
  /// Coefficient k of u'', by the phase.
  auto acceleration(int k) { return rate_.col(k).template segment<N>(coordinates(), coordinates()); }
  /// Adds coefficient k of the acceleration by a force on the casing.
  void push(const run::ScaledContact<N>& c, int k, numerics::Twin force) {
    using numerics::load;
    const numerics::Twin first = numerics::first_twice(force), second = numerics::second_twice(force);
    double* const a = &rate_(coordinates(), k);
    for (Eigen::Index h = 0; h < coordinates(); h += 2)
      numerics::store(a + h,
                      load(a + h) + (load(&c.first_push[h]) * first + load(&c.second_push[h]) * second));
  }

  /// Computes coefficient k + 1; rates by s are `pace` times rates by the phase. `pace` null: 1.
  void advance(int k, const numerics::Series* pace) {
    const double next = numerics::one_over(k + 1);
    if (!pace) {
      state_.col(k + 1) = next * rate_.col(k);
    } else if constexpr (N == Eigen::Dynamic) {
      state_.col(k + 1).setZero();
      for (int j = 0; j <= k; ++j) state_.col(k + 1) += next * (*pace)[k - j] * rate_.col(j);
    } else {
      std::array<numerics::Twin, static_cast<std::size_t>(N) + 1> sums{};
      for (int j = 0; j <= k; ++j) {
        const numerics::Twin by = numerics::both((*pace)[k - j]);
        for (std::size_t h = 0; h < sums.size(); ++h) sums[h] += by * numerics::load(&rate_(0, j) + 2 * h);
      }
      for (std::size_t h = 0; h < sums.size(); ++h)
        numerics::store(&state_(0, k + 1) + 2 * h, sums[h] * numerics::both(next));
    }
  }

  /// Writes u then u' at s, by the terms up to `highest`.
  void put_state(double s, int highest, double* to) const {
    if constexpr (N == Eigen::Dynamic) {
      const Eigen::Index size = 2 * coordinates();
      Eigen::Map<Eigen::VectorXd> sum(to, size);
      sum = state_.col(highest).head(size);
      for (int k = highest - 1; k >= 0; --k) sum = s * sum + state_.col(k).head(size);
    } else {
      std::array<numerics::Twin, static_cast<std::size_t>(N)> sums{};
      for (int k = highest; k >= 0; --k)
        for (std::size_t h = 0; h < sums.size(); ++h)
          sums[h] = sums[h] * numerics::both(s) + numerics::load(&state_(0, k) + 2 * h);
      for (std::size_t h = 0; h < sums.size(); ++h) numerics::store(to + 2 * h, sums[h]);
    }
  }

  /// Bounds, for each coordinate, of the change of u up to s.
  void put_reach(double s, Eigen::Matrix<double, N, 1>& reach) const {
    reach.setZero();
    for (int k = order; k > 0; --k) {
      reach += state_.col(k).template segment<N>(0, coordinates()).cwiseAbs();
      reach *= s;
    }
  }

 private:
  using Vector = Eigen::Matrix<double, N, 1>;
  static constexpr int rows = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N + 2;

  Eigen::Index coordinates() const { return N == Eigen::Dynamic ? system_.coordinates() : N; }

  numerics::Twin seen(const run::ScaledContact<N>& c, const double* from) const {
    numerics::Twin first{}, second{};
    for (Eigen::Index h = 0; h < coordinates(); h += 2) {
      const numerics::Twin pair = numerics::load(from + h);
      first += numerics::load(&c.first_row[h]) * pair;
      second += numerics::load(&c.second_row[h]) * pair;
    }
    return numerics::sums_of(first, second);
  }

  const run::ScaledSystem<N>& system_;
  bool driven_ = false;
  Eigen::Matrix<double, rows, order + 1> state_;  ///< coefficients of u, u', cosine and sine of the phase
  Eigen::Matrix<double, rows, order> rate_;       ///< coefficients of their rates by the phase
};

}  // namespace rubsweep::integrate::taylor
