#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/core/integrate/taylor/series_options.hpp"
#include "rubsweep/core/integrate/taylor/state_pairs.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::taylor {

/// Displacements u and velocities u' as power series of the phase from one instant; u has one more order.
template <int N>
class StateSeries {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;

  StateSeries(Eigen::Index coordinates, const SeriesOptions& options)
      : order_(options.order),
        accuracy_(options.accuracy),
        u_(coordinates, order_ + 2),
        v_(coordinates, order_ + 1) {}

  /// Starts at `state`, u then u'.
  void begin(const double* state) {
    const Eigen::Index n = u_.rows();
    u_.col(0) = Eigen::Map<const Vector>(state, n);
    v_.col(0) = u_.col(1) = Eigen::Map<const Vector>(state + n, n);
  }
  int order() const { return order_; }
  double accuracy() const { return accuracy_; }
  void set_accuracy(double accuracy) { accuracy_ = accuracy; }
  // Coefficients: of u up to order + 1, of u' up to order.
  auto u(int k) { return u_.col(k); }
  auto u(int k) const { return u_.col(k); }
  auto v(int k) { return v_.col(k); }
  auto v(int k) const { return v_.col(k); }

  /// Writes u then u' after `duration_rad`.
  void put_state(double duration_rad, double* state) const {
    const Eigen::Index n = u_.rows();
    if constexpr (N != Eigen::Dynamic) {
      put_sum(u_, order_ + 1, duration_rad, state);
      put_sum(v_, order_, duration_rad, state + n);
    } else {
      put_one_by_one(duration_rad, state);
    }
  }

  /// Writes the states after the durations at(0), ..., at(count - 1), one after another. Each has the same
  /// bits for any count. This is faster than one by one, because the sums are independent.
  template <class At>
  void put_states(int count, const At& at, double* states) const {
    const Eigen::Index numbers = 2 * u_.rows();
    int i = 0;
    if constexpr (N != Eigen::Dynamic) {
      // Number of states whose sums fit into sixteen registers.
      constexpr std::size_t together = N <= 4 ? 3 : 2;
      for (; i + static_cast<int>(together) <= count; i += static_cast<int>(together)) {
        std::array<double, together> durations;
        for (std::size_t j = 0; j < together; ++j) durations[j] = at(i + static_cast<int>(j));
        put_in_registers(durations, states + i * numbers);
      }
    }
    for (; i < count; ++i) put_one_by_one(at(i), states + i * numbers);
  }

  /// The longest duration, at most `longest_rad`, over which the last two terms stay below the accuracy times
  /// the motion's size, which counts as at least one clearance.
  double converged_rad(double longest_rad) const {
    const double length = std::max(1.0, u_.col(0).template lpNorm<Eigen::Infinity>());
    const double speed = std::max(1.0, v_.col(0).template lpNorm<Eigen::Infinity>());
    for (int k = order_ - 1; k <= order_; ++k) {
      const double term = std::max(u_.col(k).template lpNorm<Eigen::Infinity>() / length,
                                   v_.col(k).template lpNorm<Eigen::Infinity>() / speed);
      if (!std::isfinite(term)) return 0;
      longest_rad = numerics::longest_below(longest_rad, term, k, accuracy_);
    }
    return longest_rad;
  }
  /// Largest velocity at the start.
  double speed() const { return v_.col(0).template lpNorm<Eigen::Infinity>(); }

 private:
  using Series = Eigen::Matrix<double, N, Eigen::Dynamic>;

  /// Sum of the terms up to `highest`; even and odd terms are summed independently.
  static void put_sum(const Series& series, int highest, double duration_rad, double* to) {
    using Pairs = StatePairs<N>;
    const numerics::Twin step = numerics::both(duration_rad), square = step * step;
    Pairs first(series.col(highest)), second(series.col(highest - 1));
    const auto add = [&](Pairs& sums, int k) {
      const double* const term = series.col(k).data();
      for (std::size_t h = 0; h < Pairs::count; ++h)
        sums[h] = sums[h] * square + numerics::load(term + 2 * h);
    };
    int k = highest - 2;
    for (; k >= 1; k -= 2) {
      add(first, k);
      add(second, k - 1);
    }
    if (k == 0) add(first, 0);
    const Pairs &even = k == 0 ? first : second, &odd = k == 0 ? second : first;
    for (std::size_t h = 0; h < Pairs::count; ++h) numerics::store(to + 2 * h, even[h] + odd[h] * step);
  }

  void put_one_by_one(double duration_rad, double* state) const {
    if constexpr (N != Eigen::Dynamic) return put_in_registers(std::array{duration_rad}, state);
    const Eigen::Index n = u_.rows();
    Eigen::Map<Vector> u(state, n), v(state + n, n);
    u = u_.col(order_ + 1);
    v = v_.col(order_);
    u = u * duration_rad + u_.col(order_);
    for (int k = order_ - 1; k >= 0; --k) {
      u = u * duration_rad + u_.col(k);
      v = v * duration_rad + v_.col(k);
    }
  }

  template <std::size_t Count>
  void put_in_registers(const std::array<double, Count>& durations_rad, double* states) const {
    using numerics::both, numerics::Twin;
    constexpr std::size_t pairs = static_cast<std::size_t>(N) / 2, coordinates = 2 * pairs;
    Twin u[Count][pairs], v[Count][pairs];
    const auto add = [&](auto& sums, const double* term) {
      for (std::size_t i = 0; i < Count; ++i) {
        for (std::size_t h = 0; h < pairs; ++h)
          sums[i][h] = sums[i][h] * both(durations_rad[i]) + numerics::load(term + 2 * h);
      }
    };
    for (std::size_t i = 0; i < Count; ++i) {
      for (std::size_t h = 0; h < pairs; ++h) {
        u[i][h] = numerics::load(u_.col(order_ + 1).data() + 2 * h);
        v[i][h] = numerics::load(v_.col(order_).data() + 2 * h);
      }
    }
    add(u, u_.col(order_).data());
    for (int k = order_ - 1; k >= 0; --k) {
      add(u, u_.col(k).data());
      add(v, v_.col(k).data());
    }
    for (std::size_t i = 0; i < Count; ++i) {
      double* const to = states + 2 * coordinates * i;
      for (std::size_t h = 0; h < pairs; ++h) {
        numerics::store(to + 2 * h, u[i][h]);
        numerics::store(to + coordinates + 2 * h, v[i][h]);
      }
    }
  }

  int order_;
  double accuracy_;
  Series u_, v_;
};

}  // namespace rubsweep::integrate::taylor
