#include "rubsweep/analysis/branch/curves/extended_system.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/analysis/branch/curves/conditions.hpp"

namespace rubsweep::branch::curves {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Steps of central differences, in the coordinates. The step along the state is larger, as it also serves
/// third derivatives.
constexpr double usual_parameter_step = 1e-6, usual_state_step = 1e-5;
/// A grazing orbit is computed to stay short of the guard by this distance, a share of the length scale. If
/// rounding put the orbit beyond the guard, the square root of the rounding error would enter its derivative.
constexpr double miss = 4e-12;
constexpr double least_cubic = 1e-3;  ///< Smallest divisor in Newton's iteration at a branch point.

double root_of(Index states) { return std::sqrt(static_cast<double>(states)); }

/// Thrown where an evaluation of the map failed.
struct NotMade {
  orbits::Evaluation why;
};

class Extender {
 public:
  Extender(const ExtendedSystem& system, const continuation::Position& at, double difference_steps)
      : system_(system),
        orbits_(*system.orbits),
        n_(system.states),
        extra_(system.unknowns() - n_),
        at_(at),
        place_(place_of(system, at)),
        state_(state_of(system, at)),
        parameter_step_(difference_steps * usual_parameter_step),
        state_step_(difference_steps * usual_state_step) {}

  Extended make() {
    Extended extended;
    add_orbit(extended);
    if (system_.kind == continuation::EventKind::graze) {
      add_graze(extended);
    } else {
      add_condition(extended);
    }
    extended.monodromy = jet_.here;
    return extended;
  }

 private:
  struct Image {
    VectorXd state;
    MatrixXd monodromy;
  };

  Image image_at(const continuation::Position& at) const {
    Image image{state_of(system_, at), {}};
    const orbits::Evaluation evaluation =
        orbits_.returns(place_of(system_, at), image.state, &image.monodromy);
    if (evaluation != orbits::Evaluation::ok) throw NotMade{evaluation};
    if (!image.state.allFinite() || !image.monodromy.allFinite()) throw NotMade{orbits::Evaluation::failed};
    return image;
  }

  std::optional<Image> image_if_any(const continuation::Position& at) const {
    try {
      return image_at(at);
    } catch (const NotMade&) {
      return std::nullopt;
    }
  }

  /// Adds the equations of the closed orbit. Differences are one-sided where the map does not exist, or is
  /// not smooth, on the other side.
  void add_orbit(Extended& extended) {
    const Image here = image_at(at_);
    jet_.here = here.monodromy;
    extended.residual = here.state - state_;
    extended.jacobian.resize(n_, n_ + extra_);
    extended.jacobian.leftCols(n_) = (here.monodromy - MatrixXd::Identity(n_, n_)) * root_of(n_);
    for (Index k = 0; k < extra_; ++k) {
      continuation::Position moved = at_;
      moved(n_ + k) += parameter_step_;
      auto above = image_if_any(moved);
      moved(n_ + k) = at_(n_ + k) - parameter_step_;
      auto below = image_if_any(moved);
      if (!above && !below) throw NotMade{orbits::Evaluation::infeasible};
      if (above && below && system_.has_phase()) (returns_deeper(*above, *below) ? above : below).reset();
      const Image &high = above ? *above : here, &low = below ? *below : here;
      const double width = (above && below ? 2 : 1) * parameter_step_;
      extended.jacobian.col(n_ + k) = (high.state - low.state) / width;
      jet_.by_parameter.emplace_back((high.monodromy - low.monodromy) / width);
    }
    jet_.along = [this](const VectorXd& direction) { return beside(direction); };
  }

  /// Whether orbit `a` returns deeper behind the guard than `b`. Behind the guard the image of a grazing
  /// orbit contains a square root, so that differences must be taken on the other side.
  bool returns_deeper(const Image& a, const Image& b) const {
    return guard_of(place_, a.state).value > guard_of(place_, b.state).value;
  }

  std::optional<MonodromyPair> beside(const VectorXd& direction) const {
    const double step = state_step_ * root_of(n_);
    continuation::Position ahead = at_, behind = at_;
    ahead.head(n_) += state_step_ * direction;
    behind.head(n_) -= state_step_ * direction;
    auto above = image_if_any(ahead), below = image_if_any(behind);
    if (!above || !below) return std::nullopt;
    return MonodromyPair{std::move(above->monodromy), std::move(below->monodromy), step};
  }

  void add_condition(Extended& extended) {
    const bool pair = system_.kind == continuation::EventKind::neimark_sacker;
    const auto condition =
        pair ? pair_condition(jet_)
             : singular_condition(jet_, system_.kind == continuation::EventKind::period_doubling ? -1 : 1);
    if (!condition) throw NotMade{orbits::Evaluation::failed};
    extended.critical = condition->critical;
    if (system_.kind == continuation::EventKind::branch_point) drop_open_equation(extended);
    VectorXd row(n_ + extra_);
    row << root_of(n_) * condition->by_state.transpose(), condition->by_parameter.transpose();
    append(extended, condition->value, row);
  }

  /// Replaces one equation at a branch point: the closing error of the orbit along `left` vanishes there to
  /// first order, so its equation is useless. The new equation says that the second derivative along `right`
  /// is zero, as symmetry requires. Only the derivative of this equation along `right` matters.
  void drop_open_equation(Extended& extended) const {
    Critical& critical = extended.critical;
    const VectorXd& left = critical.left;
    critical.open_defect = left.dot(extended.residual);
    extended.residual += left * (critical.quadratic - critical.open_defect);
    const Eigen::RowVectorXd open = left.transpose() * extended.jacobian;
    Eigen::RowVectorXd bent = Eigen::RowVectorXd::Zero(n_ + extra_);
    // This derivative vanishes where symmetry breaking changes between supercritical and subcritical, and the
    // matrix would be singular. A larger number is used instead; it does not change the direction of the
    // curve.
    const double slope = std::copysign(std::max(std::abs(critical.cubic), least_cubic), critical.cubic);
    bent.head(n_) = root_of(n_) * slope * critical.right.transpose();
    extended.jacobian += left * (bent - open);
  }

  orbits::GuardMotion guard_of(const orbits::PlanePoint& place, const VectorXd& state) const {
    const auto guard = orbits_.guard(place, state, system_.guard);
    if (!guard) throw NotMade{orbits::Evaluation::infeasible};
    return *guard;
  }

  orbits::GuardMotion guard_at(const continuation::Position& at) const {
    return guard_of(place_of(system_, at), state_of(system_, at));
  }

  void add_graze(Extended& extended) const {
    const orbits::GuardMotion here = guard_at(at_);
    VectorXd value(n_ + extra_), rate(n_ + extra_);
    for (Index k = 0; k < value.size(); ++k) {
      continuation::Position above = at_, below = at_;
      above(k) += parameter_step_;
      below(k) -= parameter_step_;
      const orbits::GuardMotion high = guard_at(above), low = guard_at(below);
      value(k) = (high.value - low.value) / (2 * parameter_step_);
      rate(k) = (high.rate - low.rate) / (2 * parameter_step_);
    }
    extended.critical.curvature = here.curvature;
    append(extended, here.value + (system_.even ? 0 : miss), value);
    if (system_.has_phase()) append(extended, here.rate, rate);
  }

  static void append(Extended& extended, double value, const VectorXd& row) {
    const Index rows = extended.residual.size();
    extended.residual.conservativeResize(rows + 1);
    extended.jacobian.conservativeResize(rows + 1, Eigen::NoChange);
    extended.residual(rows) = value;
    extended.jacobian.row(rows) = row.transpose();
  }

  const ExtendedSystem& system_;
  const orbits::PlaneOrbits& orbits_;
  Index n_, extra_;
  const continuation::Position& at_;
  orbits::PlanePoint place_;
  VectorXd state_;
  double parameter_step_, state_step_;
  MonodromyJet jet_;
};

}  // namespace

bool has_curve(continuation::EventKind kind) {
  return kind == continuation::EventKind::fold || kind == continuation::EventKind::period_doubling ||
         kind == continuation::EventKind::neimark_sacker || kind == continuation::EventKind::branch_point ||
         kind == continuation::EventKind::graze;
}

continuation::Position position_of(const ExtendedSystem& system, const orbits::PlanePoint& place,
                                   const VectorXd& state) {
  continuation::Position at(system.unknowns());
  at.head(system.states) = state / root_of(system.states);
  if (system.has_phase()) at(system.states) = place.phase_rad;
  at.tail(2) << place.first / system.orbits->first.width(), place.second / system.orbits->second.width();
  return at;
}

orbits::PlanePoint place_of(const ExtendedSystem& system, const continuation::Position& at) {
  const Index last = at.size() - 1;
  return {at(last - 1) * system.orbits->first.width(), at(last) * system.orbits->second.width(),
          system.has_phase() ? at(system.states) : 0, system.even ? system.guard.contact : -1};
}

VectorXd state_of(const ExtendedSystem& system, const continuation::Position& at) {
  return at.head(system.states) * root_of(system.states);
}

Extended extend(const ExtendedSystem& system, const continuation::Position& at, double difference_steps) {
  try {
    return Extender(system, at, difference_steps).make();
  } catch (const NotMade& not_made) {
    Extended none;
    none.evaluation = not_made.why;
    return none;
  }
}

}  // namespace rubsweep::branch::curves
