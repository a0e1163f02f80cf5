#include "rubsweep/core/contact/dry_friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::contact {
namespace {

using Eigen::Index;

/// Smallest mobility that counts as independent, as a share of the surface's own mobility. Tangents at an
/// angle of 1e-7 rad are independent; a smaller remainder is rounding.
constexpr double independent = 1e-14;
// Tolerances of an acceleration, as shares of the sum of its terms.
constexpr double still = 1e-13;   ///< a smaller acceleration sets no friction free
constexpr double poised = 1e-12;  ///< the same for a surface whose friction is at its limit
constexpr double lawful = 1e-11;  ///< largest error that the check allows

/// Minimum over the box by a primal active set method (Stark & Parker, Bounded-variable least-squares,
/// Computational Statistics 10 (1995) 129-141). The friction of a surface is free, or fixed at one side of
/// its box. Each step frees a friction that its acceleration pulls inwards. Then all free frictions move to
/// their common minimum, or to the first side on the way. Every step lowers the same function, so that no set
/// of free frictions recurs.
class FrictionBox {
 public:
  FrictionBox(const StickMobility& mobility, const StickVector& acceleration, const StickVector& limit)
      : mobility_(mobility), acceleration_(acceleration), limit_(limit), force_(limit.size()) {
    for (Index i = 0; i < limit.size(); ++i) {
      side_[at(i)] = acceleration(i) < 0 ? -1 : 1;
      force_(i) = side_[at(i)] * limit(i);
    }
  }

  /// Active-set iteration. The number of steps is limited far above the usual number, in case rounding makes
  /// the iteration cycle; `obeys` then rejects the result.
  void minimise() {
    const Index most = 32 * limit_.size();
    for (Index step = 0; step < most; ++step) {
      const Index next = pulled_inwards();
      if (next < 0) return;
      side_[at(next)] = 0;
      free_[at(count_++)] = next;
      settle_free();
    }
  }

  const StickVector& force() const { return force_; }
  /// -1 or 1 where the friction is at a side of the box, 0 between them.
  int side(Index i) const { return side_[at(i)]; }
  /// Acceleration of slip i under the friction of all surfaces; `size` adds up the magnitudes of its terms.
  double left(Index i) const { return acceleration_(i) - mobility_.row(i).dot(force_); }
  double size(Index i) const {
    return std::abs(acceleration_(i)) + mobility_.row(i).cwiseAbs().dot(force_.cwiseAbs());
  }

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  /// Index of the surface whose friction is at a side of the box and is pulled inwards most; -1 if none.
  Index pulled_inwards() const {
    Index found = -1;
    double most = still;
    for (Index i = 0; i < limit_.size(); ++i) {
      if (side(i) == 0 || limit_(i) == 0) continue;
      const double pull = -side(i) * left(i), share = pull / size(i);
      if (pull > 0 && share > most) found = i, most = share;
    }
    return found;
  }

  /// Moves the free frictions to their common minimum. Each pass that does not reach it fixes at least one
  /// friction, so the loop ends; one last pass only corrects rounding.
  void settle_free() {
    for (int arrived = 0; count_ > 0 && arrived < 2;) {
      StickVector way(count_);
      double reach = put_way(way) ? 1 : std::numeric_limits<double>::infinity();
      bool stopped = false;
      for (Index k = 0; k < count_; ++k) {
        if (room(way, k) < reach) reach = room(way, k), stopped = true;
      }
      if (!(reach < std::numeric_limits<double>::infinity())) return;  // not finite: `obeys` rejects this
      stop_at_sides(way, reach, stopped);
      if (!stopped) ++arrived;
    }
  }

  /// Multiple of the search direction that takes the k-th free friction to the end of its box.
  double room(const StickVector& way, Index k) const {
    if (way(k) == 0) return std::numeric_limits<double>::infinity();
    const Index i = free_[at(k)];
    return std::max(0.0, (std::copysign(limit_(i), way(k)) - force_(i)) / way(k));
  }

  void stop_at_sides(const StickVector& way, double reach, bool stopped) {
    constexpr double same = 1 + 4 * std::numeric_limits<double>::epsilon();
    Index kept = 0;
    for (Index k = 0; k < count_; ++k) {
      const Index i = free_[at(k)];
      if (stopped && room(way, k) <= reach * same) {
        side_[at(i)] = way(k) > 0 ? 1 : -1;
        force_(i) = side_[at(i)] * limit_(i);
        continue;
      }
      force_(i) += reach * way(k);
      free_[at(kept++)] = i;
    }
    count_ = kept;
  }

  /// Sets `way` to the step from the present free frictions to their common minimum (Cholesky factorisation)
  /// and returns true. Where the mobility of the free frictions is singular, sets `way` to a null vector of
  /// the mobility that points downhill, and returns false.
  bool put_way(StickVector& way) const {
    StickMobility root(count_, count_);
    for (Index k = 0; k < count_; ++k) {
      for (Index j = 0; j <= k; ++j) {
        const double sum = root.row(k).head(j).dot(root.row(j).head(j));
        root(k, j) = mobility_(free_[at(k)], free_[at(j)]) - sum;
        if (j < k) root(k, j) /= root(j, j);
      }
      if (!(root(k, k) > independent * mobility_(free_[at(k)], free_[at(k)]))) {
        put_idle_way(root, k, way);
        return false;
      }
      root(k, k) = std::sqrt(root(k, k));
    }
    for (Index k = 0; k < count_; ++k) way(k) = left(free_[at(k)]);
    solve_lower(root, count_, way);
    solve_upper(root, count_, way);
    return true;
  }

  /// Null vector of the mobility: a combination of friction k and the frictions before it that accelerates no
  /// surface.
  void put_idle_way(const StickMobility& root, Index k, StickVector& way) const {
    way.setZero();
    way.head(k) = -root.row(k).head(k).transpose();
    solve_upper(root, k, way);
    way(k) = 1;
    double downhill = 0;
    for (Index j = 0; j <= k; ++j) downhill += way(j) * left(free_[at(j)]);
    if (downhill < 0) way = -way;
  }

  static void solve_lower(const StickMobility& root, Index count, StickVector& x) {
    for (Index k = 0; k < count; ++k) x(k) = (x(k) - root.row(k).head(k).dot(x.head(k))) / root(k, k);
  }
  static void solve_upper(const StickMobility& root, Index count, StickVector& x) {
    for (Index k = count; k-- > 0;) {
      for (Index j = k + 1; j < count; ++j) x(k) -= root(j, k) * x(j);
      x(k) /= root(k, k);
    }
  }

  const StickMobility& mobility_;
  const StickVector &acceleration_, &limit_;
  StickVector force_;
  std::array<int, most_sticking> side_{};
  std::array<Index, most_sticking> free_{};
  Index count_ = 0;  ///< number of free frictions
};

/// Whether the friction of surface i obeys the law of dry friction.
bool obeys(const FrictionBox& box, double limit, Index i) {
  const double left = box.left(i), allowed = lawful * box.size(i);
  if (!(std::abs(box.force()(i)) <= limit)) return false;
  return box.side(i) == 0 ? std::abs(left) <= allowed : limit == 0 || box.side(i) * left >= -allowed;
}

/// Friction of a single surface in closed form.
SettledSlips settle_one(double mobility, double acceleration, double limit) {
  const double wanted = acceleration / mobility;
  SettledSlips one;
  one.force.setConstant(1, std::clamp(wanted, -limit, limit));
  one.obeys_law = std::isfinite(wanted) && limit >= 0;
  one.poised[0] = limit > 0 && std::abs(wanted) >= limit && std::abs(wanted) - limit <= poised * limit;
  one.slips[0] = std::abs(wanted) < limit ? Slip::sticking : wanted >= 0 ? Slip::forward : Slip::backward;
  return one;
}

}  // namespace

StickVector holding_forces(const StickMobility& mobility, const StickVector& acceleration) {
  if (acceleration.size() == 1) return acceleration / mobility(0, 0);
  return numerics::dense::least_norm_solution(Eigen::MatrixXd(mobility), Eigen::VectorXd(acceleration));
}

SettledSlips settle_slips(const StickMobility& mobility, const StickVector& acceleration,
                          const StickVector& limit) {
  if (limit.size() == 1) return settle_one(mobility(0, 0), acceleration(0), limit(0));
  FrictionBox box(mobility, acceleration, limit);
  box.minimise();
  SettledSlips settled;
  settled.force = box.force();
  settled.obeys_law = true;
  for (Index i = 0; i < limit.size(); ++i) {
    settled.obeys_law = settled.obeys_law && obeys(box, limit(i), i);
    const auto k = static_cast<std::size_t>(i);
    const double left = box.left(i);
    const double way = limit(i) > 0 ? box.side(i) : left;
    settled.slips[k] = box.side(i) == 0 ? Slip::sticking : way >= 0 ? Slip::forward : Slip::backward;
    settled.poised[k] = box.side(i) != 0 && std::abs(left) <= poised * box.size(i);
  }
  return settled;
}

SettledSlips settle_slips(const StickMobility& mobility, const StickVector& acceleration,
                          const StickVector& more, StickVector limit, const StickVector& sliding) {
  SettledSlips settled = settle_slips(mobility, acceleration + more, limit);
  for (bool loose = true; loose && settled.obeys_law;) {
    loose = false;
    for (Index i = 0; i < limit.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (settled.slips[k] == Slip::sticking || settled.poised[k] || !(limit(i) > sliding(i))) continue;
      limit(i) = sliding(i);
      loose = true;
    }
    if (loose) settled = settle_slips(mobility, acceleration, limit);
  }
  return settled;
}

}  // namespace rubsweep::contact
