#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "rubsweep/contact/friction_law.hpp"
#include "rubsweep/integrate/taylor/contact_slopes.hpp"
#include "rubsweep/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Tangent vectors of a motion, small changes of its state, moved along its expansions: w'' = -stiffness w -
/// damping w' + contacts' slopes. At a change of mode they go on without a jump, as the force does. Where a
/// contact sticks, they keep its slip, too.
template <int N>
class TangentExpansion {
 public:
  /// Four orders less than a motion's. With steps as `longest_step` cuts them for tangents the first term
  /// left out is below 5e-12.
  static constexpr int order = numerics::most_taylor_order - 4;

  explicit TangentExpansion(const run::ScaledSystem<N>& system)
      : system_(system), slopes_(system.contacts.size()) {}

  /// One per column, as TurnRequest::tangent_vectors.
  void begin(const Eigen::MatrixXd& tangents) {
    count_ = tangents.cols();
    if (count_ == 0) return;
    const Eigen::Index n = system_.coordinates();
    if (terms_.empty() || terms_[0].cols() != count_) {
      terms_.assign(order + 1, Directions(n, count_));
      rates_.assign(order + 1, Directions(n, count_));
      force_.resize(2, count_);
      keeping_.resize(contact::most_sticking, count_);
      distance_.assign(system_.contacts.size() * (order + 1), Pair(2, count_));
      distance_rate_ = distance_;
      if (std::ranges::any_of(system_.contacts,
                              [](const auto& c) { return contact::dry_coefficient(c.friction) > 0; })) {
        distance_acceleration_ = distance_;
        holding_.assign(distance_.size(), Line(count_));
      }
    }
    terms_[0] = tangents.topRows(n);
    rates_[0] = tangents.bottomRows(n);
  }

  Eigen::Index count() const { return count_; }

  /// Moves them over `duration_rad` of the motion as it was expanded.
  void pass(Expansion<N>& motion, double duration_rad) {
    if (count_ == 0) return;
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      if (touches(motion, i)) slopes_[i].make(motion.contact(i), order);
    }
    for (int k = 0; k < order; ++k) add_term(motion, k);
    sum_up(terms_, duration_rad);
    sum_up(rates_, duration_rad);
  }

  void put(Eigen::MatrixXd& tangents) const {
    if (count_ == 0) return;
    const Eigen::Index n = system_.coordinates();
    tangents.topRows(n) = terms_[0];
    tangents.bottomRows(n) = rates_[0];
  }

 private:
  static constexpr int most_columns = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N;
  using Directions = Eigen::Matrix<double, N, Eigen::Dynamic, Eigen::ColMajor, N, most_columns>;
  using Pair = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, most_columns>;

  using Line = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, most_columns>;

  static bool touches(Expansion<N>& motion, std::size_t i) {
    return motion.contact(i).mode() != contact::Mode::open;
  }

  Pair& distance(std::size_t i, int k) { return distance_[i * (order + 1) + static_cast<std::size_t>(k)]; }
  Pair& distance_rate(std::size_t i, int k) {
    return distance_rate_[i * (order + 1) + static_cast<std::size_t>(k)];
  }

  /// Coefficient k + 1 of displacements and rates.
  void add_term(Expansion<N>& motion, int k) {
    const auto index = static_cast<std::size_t>(k);
    Directions& next = rates_[index + 1];
    if (system_.diagonal) {
      next = -(system_.stiffness_diagonal.asDiagonal() * terms_[index]);
      next -= system_.damping_diagonal.asDiagonal() * rates_[index];
    } else {
      next.noalias() = -system_.stiffness * terms_[index];
      next.noalias() -= system_.damping * rates_[index];
    }
    for (std::size_t i = 0; i < slopes_.size(); ++i) {
      if (touches(motion, i)) add_contact(motion, i, k, next);
    }
    if (motion.sticking() > 0) hold(motion, k, next);
    next *= numerics::one_over(k + 1);
    terms_[index + 1] = rates_[index] * numerics::one_over(k + 1);
  }

  std::size_t place(std::size_t i, int k) const { return i * (order + 1) + static_cast<std::size_t>(k); }

  /// Coefficient k of what holds the contacts that stick: of d1 d2'' - d2 d1'' = s r' (at a flat stop d2'' =
  /// 0) small changes obey the derivative, with the sliding speed s as it is.
  void hold(Expansion<N>& motion, int k, Directions& acceleration) {
    const auto count = static_cast<Eigen::Index>(motion.sticking());
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t i = motion.stuck(j);
      keeping_.row(j).noalias() = motion.tangential_row(i) * acceleration;
      if (motion.contact(i).law().annular) keeping_.row(j) -= keeping_term(motion, i, k);
    }
    for (Eigen::Index column = 0; column < count_; ++column) {
      const contact::StickVector rest = keeping_.col(column).head(count);
      keeping_.col(column).head(count) = contact::holding_forces(motion.mobility(), rest);
    }
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t i = motion.stuck(j);
      acceleration.noalias() += motion.tangential_push(i) * keeping_.row(j);
      holding_[place(i, k)] = keeping_.row(j);
    }
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto& c = system_.contacts[motion.stuck(j)];
      distance_acceleration_[place(motion.stuck(j), k)].row(0).noalias() = c.first_row * acceleration;
      distance_acceleration_[place(motion.stuck(j), k)].row(1).noalias() = c.second_row * acceleration;
    }
  }

  Line keeping_term(Expansion<N>& motion, std::size_t i, int k) {
    const auto& c = system_.contacts[i];
    const ContactSeries& contact = motion.contact(i);
    const ContactSlopes& slopes = slopes_[i];
    const double sliding =
        (contact.d1[0] * contact.d2[1] - contact.d2[0] * contact.d1[1]) / contact.length()[0];
    // Of the next order only the motion's coefficient is not at hand yet.
    Pair next(2, count_);
    next.row(0).noalias() = c.first_row * rates_[static_cast<std::size_t>(k)] * numerics::one_over(k + 1);
    next.row(1).noalias() = c.second_row * rates_[static_cast<std::size_t>(k)] * numerics::one_over(k + 1);
    Line sum = slopes.cosine()[0] * next.row(0) + slopes.sine()[0] * next.row(1);
    for (int j = 1; j <= k + 1; ++j) {
      const Pair& w = distance(i, k + 1 - j);
      sum += slopes.cosine()[j] * w.row(0) + slopes.sine()[j] * w.row(1);
    }
    sum *= sliding * (k + 1);
    for (int j = 0; j <= k; ++j) {
      const Pair& w = distance(i, j);
      sum -= contact.second_acceleration()[k - j] * w.row(0) - contact.first_acceleration()[k - j] * w.row(1);
    }
    for (int j = 1; j <= k; ++j) {
      const Pair& b = distance_acceleration_[place(i, k - j)];
      sum -= contact.d1[j] * b.row(1) - contact.d2[j] * b.row(0);
    }
    return sum / contact.length()[0];
  }

  void add_contact(Expansion<N>& motion, std::size_t i, int k, Directions& acceleration) {
    const auto& c = system_.contacts[i];
    const ContactSlopes& slopes = slopes_[i];
    const auto index = static_cast<std::size_t>(k);
    distance(i, k).row(0).noalias() = c.first_row * terms_[index];
    distance(i, k).row(1).noalias() = c.second_row * terms_[index];
    if (slopes.has_rate()) {
      distance_rate(i, k).row(0).noalias() = c.first_row * rates_[index];
      distance_rate(i, k).row(1).noalias() = c.second_row * rates_[index];
    }
    force_.setZero();
    for (int j = 0; j <= k && j < slopes.terms(); ++j) {
      force_.noalias() += entries(slopes.by_d(), j).lazyProduct(distance(i, k - j));
      if (slopes.has_rate())
        force_.noalias() += entries(slopes.by_rate(), j).lazyProduct(distance_rate(i, k - j));
    }
    if (motion.contact(i).sticks() && motion.contact(i).law().annular) {
      for (int j = 0; j < k; ++j) {
        force_.row(0) -= slopes.sine()[k - j] * holding_[place(i, j)];
        force_.row(1) += slopes.cosine()[k - j] * holding_[place(i, j)];
      }
    }
    acceleration.noalias() += c.first_push * force_.row(0);
    acceleration.noalias() += c.second_push * force_.row(1);
  }

  static Eigen::Matrix2d entries(const std::array<numerics::Series, 4>& of, int j) {
    Eigen::Matrix2d matrix;
    matrix << of[0][j], of[1][j], of[2][j], of[3][j];
    return matrix;
  }

  void sum_up(std::vector<Directions>& terms, double duration_rad) {
    Directions& sum = sum_;
    sum = terms[order];
    for (std::size_t k = order; k-- > 0;) sum = sum * duration_rad + terms[k];
    terms[0] = sum;
  }

  const run::ScaledSystem<N>& system_;
  Eigen::Index count_ = 0;
  std::vector<Directions> terms_, rates_;  ///< by order; the first ones are where they are now
  std::vector<Pair> distance_, distance_rate_, distance_acceleration_;
  Pair force_;
  std::vector<Line> holding_;  ///< of contacts that stick, as `distance_`
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> keeping_;
  Directions sum_;
  std::vector<ContactSlopes> slopes_;
};

}  // namespace rubsweep::integrate::taylor
