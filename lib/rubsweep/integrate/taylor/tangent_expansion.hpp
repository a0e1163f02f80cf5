#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/integrate/taylor/contact_slopes.hpp"
#include "rubsweep/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Tangent vectors of a motion, small changes of its state, moved along its expansions: w'' = -stiffness w -
/// damping w' + contacts' slopes. At a change of mode they go on without a jump, as the force does.
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
      distance_.assign(system_.contacts.size() * (order + 1), Pair(2, count_));
      distance_rate_ = distance_;
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
      if (touches(motion, i)) add_contact(i, k, next);
    }
    next *= numerics::one_over(k + 1);
    terms_[index + 1] = rates_[index] * numerics::one_over(k + 1);
  }

  void add_contact(std::size_t i, int k, Directions& acceleration) {
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
  std::vector<Pair> distance_, distance_rate_;
  Pair force_;
  Directions sum_;
  std::vector<ContactSlopes> slopes_;
};

}  // namespace rubsweep::integrate::taylor
