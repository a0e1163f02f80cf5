#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/contact_directions.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"

namespace rubsweep::integrate::taylor {

/// Contacts of an expansion that stick or creep, in the order of their indices, and their friction.
template <int N>
class StickingContacts {
 public:
  /// `system` must outlive this object.
  explicit StickingContacts(const run::ScaledSystem<N>& system) : system_(system) {}

  void clear() { count_ = 0; }
  void add(std::size_t i) { list_[count_++] = i; }
  std::size_t count() const { return count_; }
  std::size_t operator[](Eigen::Index j) const { return list_[static_cast<std::size_t>(j)]; }
  const contact::StickMobility& mobility() const { return mobility_; }

  /// Row of the tangential velocity of contact `i` at the start of the expansion, with its series.
  Eigen::Matrix<double, 1, N> row(std::size_t i, const ContactSeries& series) const {
    const auto& c = system_.contacts[i];
    return series.cosine() * c.second_row - series.sine() * c.first_row;
  }
  Eigen::Matrix<double, N, 1> push(std::size_t i, const ContactSeries& series) const {
    const auto& c = system_.contacts[i];
    return series.cosine() * c.second_push - series.sine() * c.first_push;
  }

  /// Adds coefficient k of the holding forces to that of the acceleration of the coordinates. Call it in
  /// order of k; `contacts`: series of all contacts.
  template <class Contact, class Acceleration>
  void hold(int k, std::vector<Contact>& contacts, Acceleration&& acceleration) {
    const auto count = static_cast<Eigen::Index>(count_);
    const auto row_of = [&](Eigen::Index j) { return row((*this)[j], contacts[(*this)[j]]); };
    const auto push_of = [&](Eigen::Index j) { return push((*this)[j], contacts[(*this)[j]]); };
    if (k == 0) {
      mobility_.resize(count, count);
      for (Eigen::Index j = 0; j < count; ++j) {
        for (Eigen::Index i = 0; i < count; ++i) mobility_(i, j) = -row_of(i).dot(push_of(j).transpose());
      }
    }
    contact::StickVector rest(count);
    for (Eigen::Index j = 0; j < count; ++j)
      rest(j) = row_of(j).dot(acceleration.transpose()) - contacts[(*this)[j]].keeping_term(k);
    const contact::StickVector force = contact::holding_forces(mobility_, rest);
    for (Eigen::Index j = 0; j < count; ++j) acceleration += force(j) * push_of(j);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t i = (*this)[j];
      contacts[i].hold(k, force(j), at_contact(system_.contacts[i], acceleration));
    }
  }

 private:
  const run::ScaledSystem<N>& system_;
  std::array<std::size_t, contact::most_sticking> list_{};
  std::size_t count_ = 0;
  contact::StickMobility mobility_;
};

}  // namespace rubsweep::integrate::taylor
