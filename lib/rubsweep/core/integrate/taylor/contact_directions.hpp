#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/state_pairs.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::taylor {

/// Components of a coordinate vector in a contact's two directions.
template <int N, class Vector>
numerics::Twin at_contact(const run::ScaledContact<N>& c, const Vector& of) {
  return numerics::Twin{c.first_row.dot(of), c.second_row.dot(of)};
}

/// Projection of a structure whose coordinates form pairs onto a contact's two directions: the motion of the
/// contact, and the accelerations by its force.
template <int N>
class AnyDirections {
 public:
  using Twin = numerics::Twin;

  explicit AnyDirections(const run::ScaledContact<N>& c)
      : first_push_(c.first_push),
        second_push_(c.second_push),
        first_row_(c.first_row),
        second_row_(c.second_row),
        by_first_{c.first_row.dot(c.first_push), c.second_row.dot(c.first_push)},
        by_second_{c.first_row.dot(c.second_push), c.second_row.dot(c.second_push)} {}

  /// A force on the casing, each component stored twice.
  struct Force {
    explicit Force(Twin force) : first(numerics::first_twice(force)), second(numerics::second_twice(force)) {}
    Twin first, second;
  };

  /// Partial sums of the projection of pairs onto the contact's two directions, two sums each.
  struct Seen {
    Twin first{}, second{};
  };
  void see(std::size_t pair, Twin moved, Seen& seen) const {
    seen.first += first_row_[pair] * moved;
    seen.second += second_row_[pair] * moved;
  }
  /// Components in the contact's two directions, including the contribution of a force.
  Twin total(const Seen& seen, const Force& force) const {
    return numerics::sums_of(seen.first, seen.second) + by_first_ * force.first + by_second_ * force.second;
  }
  Twin pushed(std::size_t pair, Twin moved, const Force& force) const {
    return moved + first_push_[pair] * force.first + second_push_[pair] * force.second;
  }

 private:
  StatePairs<N> first_push_, second_push_, first_row_, second_row_;
  /// Acceleration of the contact itself per newton along each of its directions.
  Twin by_first_, by_second_;
};

/// AnyDirections for a contact whose directions are parallel to the coordinates: in every pair the first
/// coordinate is along the first direction (or against it), the second along the second. This takes half the
/// products and none across a pair.
template <int N>
class AxisDirections {
 public:
  using Twin = numerics::Twin;
  using Force = Twin;
  using Seen = Twin;

  /// Empty where the directions are not parallel to the coordinates.
  static std::optional<AxisDirections> of(const run::ScaledContact<N>& c) {
    for (Eigen::Index i = 0; i < c.first_row.size(); ++i) {
      const bool first = i % 2 == 0;
      const auto& other_row = first ? c.second_row : c.first_row;
      const auto& other_push = first ? c.second_push : c.first_push;
      if (other_row(i) != 0 || other_push(i) != 0) return std::nullopt;
    }
    return AxisDirections(c);
  }

  void see(std::size_t pair, Twin moved, Seen& seen) const { seen += row_[pair] * moved; }
  Twin total(Seen seen, Force force) const { return seen + by_force_ * force; }
  Twin pushed(std::size_t pair, Twin moved, Force force) const { return moved + push_[pair] * force; }

 private:
  explicit AxisDirections(const run::ScaledContact<N>& c)
      : push_(c.first_push + c.second_push),
        row_(c.first_row + c.second_row),
        by_force_{c.first_row.dot(c.first_push), c.second_row.dot(c.second_push)} {}

  StatePairs<N> push_, row_;
  Twin by_force_;
};

/// Placeholder for directions, contact and variations of tangent vectors where nothing touches.
struct NoContact {
  using Twin = numerics::Twin;

  struct Force {
    explicit Force(Twin) {}
  };
  struct Seen {};
  void see(std::size_t, Twin, Seen&) const {}
  Twin total(Seen, Force) const { return Twin{}; }
  Twin pushed(std::size_t, Twin moved, Force) const { return moved; }

  Twin force_term(int) const { return Twin{}; }
  void set_velocity(int, Twin) const {}
  template <class Term>
  Term force_term(int, const Term&) const {
    return Term{};
  }
};

/// AxisDirections where possible; both give the same bits.
template <int N>
using ContactDirections = std::variant<AnyDirections<N>, AxisDirections<N>>;

template <int N>
ContactDirections<N> directions_of(const run::ScaledContact<N>& c) {
  if (const auto axes = AxisDirections<N>::of(c)) return *axes;
  return AnyDirections<N>(c);
}

}  // namespace rubsweep::integrate::taylor
