#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::integrate::adaptive {

/// Tangent vectors of an adaptive run with contacts whose law is not linear. They obey the variational
/// equation of the present law. Over each step of the motion, its method moves them, or dopri5 with its own
/// steps; they do not change the motion. After the state, a vector contains the change of the damping of
/// every contact whose damping depends on its approach speed. `Law`: that of a scene, without further numbers
/// after its state, because their derivatives would be missing.
template <class Law>
class StepTangents final : public RightHandSide {
 public:
  /// `law` must outlive this.
  explicit StepTangents(Law& law) : law_(law) {
    const auto& contacts = law.system().contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (!contacts[i].law) continue;
      moves_ = true;
      if (contacts[i].law->remembers()) remembering_.push_back(i);
    }
  }

  /// Whether there are any tangent vectors at present.
  bool any() const { return count_ > 0; }
  /// Changes of the state, one per column.
  auto changes() { return vectors().topRows(states()); }
  /// Work since the start of the run, as a number of evaluations of the right-hand side.
  long work() const { return work_; }

  /// Begins a turn at `state`. A contact whose damping depends on its approach speed may still touch at the
  /// start of the turn. Then only a vector that continues the last vector of the turn before (times any
  /// factor) can be moved, because it includes the change of this damping.
  void begin(const run::TurnRequest& request, double tolerance, const State& state) {
    const double length = any_remembers() ? length_of_last(request.tangent_vectors) : 0;
    count_ = moves_ && (length > 0 || !any_remembers()) ? request.tangent_vectors.cols() : 0;
    if (count_ == 0) return;
    const double wanted = std::max(request.tangent_accuracy, tolerance);
    if (!method_ || tolerance_ != wanted) {
      tolerance_ = wanted;
      method_ = make_step_method({.stepper = run::Stepper::dopri5, .relative_tolerance = wanted});
    }
    const auto size = static_cast<std::size_t>(rows() * count_);
    for (State* numbers : {&inner_.start, &inner_.start_rate, &inner_.end, &inner_.end_rate})
      numbers->assign(size, 0.0);
    at_ = at_rate_ = state;
    changes() = request.tangent_vectors;
    if (length > 0) vectors().bottomRows(rows() - states()) = length * last_.tail(rows() - states());
    keep_sticking(state);
  }

  /// Forgets earlier turns.
  void forget() {
    last_.resize(0);
    size_ = first_size;
  }

  /// Moves the vectors over the step of the motion up to `end_phase`.
  void follow(StepMethod& motion, RightHandSide& of_motion, const Step& step, double end_phase) {
    Vectors moved = vectors();
    if (motion.move_tangents(step, end_phase, remembering_, tolerance_, moved)) {
      work_ += work_of_slopes;
      return;
    }
    motion_ = &motion, of_motion_ = &of_motion, step_ = &step;
    inner_.start_phase = step.start_phase;
    (*this)(inner_.start, inner_.start_rate, inner_.start_phase);
    double size = size_;
    for (int attempts = 0; inner_.start_phase < end_phase; ++attempts) {
      const double left = end_phase - inner_.start_phase;
      const bool last = 1.000001 * size >= left;
      double next = last ? left : size;
      if (!method_->try_step(*this, inner_, next)) {
        size = next;
        if (size < smallest_size || attempts > most_attempts) return give_up();
        continue;
      }
      size_ = size = last ? std::max(size, next) : next;
      inner_.turn_around();
      inner_.start_phase = last ? end_phase : inner_.end_phase;
    }
  }

  /// Contact `i` begins to touch, in its new mode; its damping follows from this closing speed.
  void begin_impact(std::size_t i, const State& state, const State& rate) {
    const auto place = std::ranges::find(remembering_, i);
    if (place == remembering_.end()) return;
    const contact::Kinematics k = law_.kinematics(i, state, rate);
    const auto [penetration, speed] = approach_gradients(i, state);
    const bool own =
        k.closing_speed > contact::CurvedLaw::slowest_approach * law_.system().contacts[i].clearance;
    auto memory = vectors().row(states() + (place - remembering_.begin()));
    if (!own) {
      memory.setZero();
      return;
    }
    // Contact begins later by -(change of the penetration) / speed.
    const Eigen::RowVectorXd change = speed - k.closing_acceleration / k.closing_speed * penetration;
    memory = -law_.impact_damping(i) / k.closing_speed * (change * changes());
  }

  /// The slip of contact `i` has reached zero. Arguments: the rates of the state before and after.
  void cross_stop(std::size_t i, const State& state, const State& before, const State& after) {
    law::cross_slip(law_, i, state, before, after, changes());
  }

  /// Stores gradient and rate of the distance between the friction that holds contact `i` and its limit,
  /// before the contact is released. `before`: the rate of the state.
  void see_release(std::size_t i, contact::Slip slip, const State& state, const State& before, double phase) {
    release_gradient_ = law_.reserve_gradient(i, slip, state, at_rate_, phase);
    const auto held_n = [&](double at) {
      law_.loose(state, at_rate_, at);
      return law_.hold(state, at_rate_).force_n(i);
    };
    // forces are sines of the phase, so that the error is of second order in this step
    constexpr double nudge = 1e-4;
    const double by_phase = (held_n(phase + nudge) - held_n(phase - nudge)) / (2 * nudge);
    const Eigen::Map<const Eigen::VectorXd> rate(before.data(), states());
    release_rate_ = release_gradient_.dot(rate) - contact::sign_of(slip) * by_phase;
  }
  /// The contact was released. Arguments: the rates of the state before and after.
  void cross_release(const State& before, const State& after) {
    law::cross(release_gradient_, release_rate_, before, after, changes());
  }

  /// Called after an impulse. If a contact sticks, it also sticks in neighbouring motions.
  void keep_sticking(const State& state) { law_.keep_sticking(state, changes()); }

  /// The turn is over.
  void finish(run::TurnReport& report) {
    last_.resize(0);
    if (!any()) return;
    report.tangent_vectors.fill(states(), count_) = changes();
    if (count_ == 1) last_ = vectors().col(0);
  }

  void operator()(const State& x, State& rate, double phase) override {
    motion_->state_at(*of_motion_, *step_, phase, at_);
    typename Law::Holding holding;
    if (law_.stuck_contacts().count > 0) {
      law_.loose(at_, at_rate_, phase);
      holding = law_.hold(at_, at_rate_);
    }
    law_.slopes(at_, holding, by_u_, by_v_);
    work_ += work_of_slopes;
    const Eigen::Index n = law_.system().coordinates();
    const ConstVectors from(x.data(), rows(), count_);
    Vectors to(rate.data(), rows(), count_);
    to.topRows(n) = from.middleRows(n, n);
    to.middleRows(n, n).noalias() = by_u_ * from.topRows(n);
    to.middleRows(n, n).noalias() += by_v_ * from.middleRows(n, n);
    for (std::size_t k = 0; k < remembering_.size(); ++k) {
      const auto row = states() + static_cast<Eigen::Index>(k);
      find_push_by_damping(remembering_[k]);
      to.middleRows(n, n).noalias() += push_.tail(n) * from.row(row);
      to.row(row).setZero();
    }
  }
  /// Unused: no implicit method moves tangent vectors.
  void jacobian(const State&, double*, double, State&) override {}
  double friction_ratio(const State&) override { return 0; }

 private:
  using Vectors = Eigen::Map<Eigen::MatrixXd>;
  using ConstVectors = Eigen::Map<const Eigen::MatrixXd>;
  static constexpr double first_size = 1e-3, smallest_size = 1e-14;
  static constexpr int most_attempts = 100'000;  ///< limit for one step of the motion
  static constexpr long work_of_slopes = 3;

  Eigen::Index states() const { return 2 * law_.system().coordinates(); }
  Eigen::Index rows() const { return states() + static_cast<Eigen::Index>(remembering_.size()); }
  Vectors vectors() { return {inner_.start.data(), rows(), count_}; }

  /// Whether the damping of some contact cannot be computed from the state.
  bool any_remembers() const {
    return std::ranges::any_of(remembering_,
                               [&](std::size_t i) { return law_.modes()[i] != contact::Mode::open; });
  }
  /// Factor by which the requested vector is a multiple of the vector at the end of the turn before; 0 where
  /// it is no multiple.
  double length_of_last(const Eigen::MatrixXd& asked) const {
    constexpr double rounding = 1e-12;
    if (asked.cols() != 1 || last_.size() == 0) return 0;
    const auto before = last_.head(states());
    const double length = asked.norm() / before.norm();
    return (asked - length * before).norm() <= rounding * asked.norm() ? length : 0;
  }

  /// Returning no vectors is better than returning wrong vectors.
  void give_up() { count_ = 0; }

  /// Derivatives by the state of the penetration of contact `i` and of its closing speed.
  std::pair<Eigen::RowVectorXd, Eigen::RowVectorXd> approach_gradients(std::size_t i,
                                                                       const State& state) const {
    const auto& c = law_.system().contacts[i];
    const contact::ContactFrame f = law_.frame_at(i, state);
    const Eigen::Index n = c.first_row.size();
    Eigen::RowVectorXd penetration = Eigen::RowVectorXd::Zero(states()), speed(states());
    penetration.head(n) = f.cosine * c.first_row + f.sine * c.second_row;
    speed << f.sliding_speed * f.curvature * law::tangential_row(c, f), penetration.head(n);
    return {penetration, speed};
  }

  /// Derivative of the scaled acceleration by the damping of contact `i`, including the friction that holds
  /// sticking contacts. Leading zeros stand for the displacements.
  void find_push_by_damping(std::size_t i) {
    push_.setZero(states());
    if (law_.modes()[i] != contact::Mode::sprung) return;
    const auto& c = law_.system().contacts[i];
    const contact::ContactFrame f = law_.frame_at(i, at_);
    push_.tail(c.first_push.size()) = law_.normal_force(i, f.penetration, f.closing_speed).spring_n *
                                      f.closing_speed * (f.cosine * c.first_push + f.sine * c.second_push);
    law_.keep_sticking(at_, push_);
  }

  Law& law_;
  bool moves_ = false;
  std::vector<std::size_t> remembering_;  ///< contacts whose damping depends on their own approach speed
  Eigen::Index count_ = 0;
  std::unique_ptr<StepMethod> method_;
  double tolerance_ = 0;
  double size_ = first_size;  ///< next step to try
  Step inner_;
  StepMethod* motion_ = nullptr;
  RightHandSide* of_motion_ = nullptr;
  const Step* step_ = nullptr;
  State at_, at_rate_;  ///< state and rate of the motion
  typename Law::Matrix by_u_, by_v_;
  /// last_: the vector at the end of the turn before if it was the only one; otherwise empty
  Eigen::VectorXd push_, last_;
  Eigen::RowVectorXd release_gradient_;
  double release_rate_ = 0;
  long work_ = 0;
};

/// Whether a run with this law may have tangent vectors.
template <class Law>
inline constexpr bool has_step_tangents = std::is_same_v<Law, law::Dynamics<Law::coordinates, false>>;

struct NoTangents {
  template <class Law>
  explicit NoTangents(const Law&) {}
};
/// Tangent vectors of a run with this law, or a stand-in without any.
template <class Law>
using Tangents = std::conditional_t<has_step_tangents<Law>, StepTangents<Law>, NoTangents>;

/// Calls `act` with the tangent vectors of this turn, if there are any.
template <class Vectors, class Act>
void to_tangents(Vectors& vectors, const Act& act) {
  if constexpr (!std::is_same_v<Vectors, NoTangents>) {
    if (vectors.any()) act(vectors);
  }
}

}  // namespace rubsweep::integrate::adaptive
