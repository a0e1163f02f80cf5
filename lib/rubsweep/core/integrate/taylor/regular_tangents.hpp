#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "rubsweep/core/integrate/taylor/regular_expansion.hpp"
#include "rubsweep/core/integrate/taylor/regular_series.hpp"
#include "rubsweep/core/integrate/taylor/regular_slopes.hpp"
#include "rubsweep/core/integrate/taylor/tangent_convergence.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Tangent vectors of a RegularExpansion as power series of its time s: d(w, w') / ds = pace (w', w''), where
/// w'' is linear in w and w'. Vectors may also have the change of a contact's damping in further rows.
template <int N>
class RegularTangents {
 public:
  /// `system` must outlive this object.
  explicit RegularTangents(const run::ScaledSystem<N>& system)
      : system_(system), series_(system), slopes_(system.contacts.size()), seen_(system.contacts.size()) {}

  /// Moves `vectors` (2n rows of the state, then a row for each contact of `remembering`) from s = 0 to `s`.
  /// Terms are added until as many in a row as may be zero, and one more, are at most `accuracy` times the
  /// largest of the vector. False, with the vectors as they were, where the series end before.
  bool pass(RegularExpansion<N>& motion, double s, double accuracy,
            const std::vector<std::size_t>& remembering, Eigen::Map<Eigen::MatrixXd> vectors) {
    wanted_ = 4;
    for (const std::size_t i : motion.touching()) {
      slopes_[i].make(motion.contact(i), order);
      if (motion.contact(i).is_pace()) wanted_ = motion.contact(i).power().halves + 2;
    }
    moved_ = vectors;
    for (Eigen::Index j = 0; j < vectors.cols(); ++j) {
      if (!pass_one(motion, s, accuracy, remembering, moved_.col(j).data())) return false;
    }
    vectors = moved_;
    return true;
  }

 private:
  static constexpr int order = RegularSeries<N>::order;
  using Size = TangentConvergence<1>::Sizes;

  bool pass_one(const RegularExpansion<N>& motion, double s, double accuracy,
                const std::vector<std::size_t>& remembering, double* vector) {
    series_.begin(vector, numerics::Twin{});
    TangentConvergence<1> convergence(accuracy, Size(series_.size(0, 0)), Size(series_.size(1, 0)), wanted_);
    double power = 1;
    for (int k = 0; k < order && !convergence.all_converged(); ++k) {
      series_.begin_rate(k);
      for (const std::size_t i : motion.touching()) {
        numerics::Twin force = force_term(i, k);
        const auto place = std::ranges::find(remembering, i) - remembering.begin();
        if (place < std::ssize(remembering))
          force += slopes_[i].by_damping[k] * numerics::both(vector[2 * system_.coordinates() + place]);
        series_.push(system_.contacts[i], k, force);
      }
      series_.advance(k, motion.pace());
      power *= s;
      convergence.add(k + 1, Size(power * series_.size(0, k + 1)), Size(power * series_.size(1, k + 1)));
    }
    if (!convergence.all_converged()) return false;
    series_.put_state(s, convergence.order(0, order), vector);
    return true;
  }

  /// Coefficient k of the change of the force of contact `i` by the displacements and their rates.
  numerics::Twin force_term(std::size_t i, int k) {
    const numerics::Twin moved = series_.distance(system_.contacts[i], k),
                         speed = series_.velocity(system_.contacts[i], k);
    const RegularSlopes& slopes = slopes_[i];
    auto& seen = seen_[i];
    seen[0].set(k, moved[0]);
    seen[1].set(k, speed[0]);
    numerics::Twin force = product_term(slopes.by[0], seen[0], k) + product_term(slopes.by[1], seen[1], k);
    if (slopes.only_first) return force;
    seen[2].set(k, moved[1]);
    seen[3].set(k, speed[1]);
    return force + product_term(slopes.by[2], seen[2], k) + product_term(slopes.by[3], seen[3], k);
  }

  const run::ScaledSystem<N>& system_;
  RegularSeries<N> series_;  ///< the present vector
  /// Small terms in a row that end a series. Where a root of the penetration is the pace, only each (2 n +
  /// 2)nd term need differ from zero.
  int wanted_ = 4;
  Eigen::MatrixXd moved_;
  std::vector<RegularSlopes> slopes_;
  /// Both components of w and w' at each contact: w1, w1', w2, w2'.
  std::vector<std::array<numerics::PlaneSeries, 4>> seen_;
};

}  // namespace rubsweep::integrate::taylor
