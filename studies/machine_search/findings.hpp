#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/sweep/row.hpp"

namespace rubsweep::machine_search {

/// How far a map shows one finding of the paper, from 0 (not at all) to 1 (wholly), and how much that counts.
struct Mark {
  std::string_view finding;
  double value = 0;
  double weight = 1;
};

using Rows = std::vector<sweep::Row>;

/// Marks of the map of one stop: orders 2 to 5 at whirl ratio 0.1 (each starting above n natural
/// frequencies), tongues that lean, gaps between them, larger n from smaller unbalance, few irregular cells.
std::vector<Mark> one_side_marks(const Rows& map);

/// Marks of two stops with equal casings: synchronous motion far up in speed at larger unbalance,
/// subharmonics at smaller unbalance alone, of odd order alone.
std::vector<Mark> both_sides_marks(const Rows& map);

/// Marks of two stops with unequal casings: even orders.
std::vector<Mark> unequal_casings_marks(const Rows& map);

/// Marks of the centred annulus: a circle at low speed, an oval at high speed and from smaller unbalance, no
/// dry whip.
std::vector<Mark> annulus_marks(const Rows& map);

/// Marks of the offset annulus, beside the map `centred` whose rows i have the same unbalance: the circle to
/// higher speed, 1/2 and 1/3 slightly above twice and three times the natural frequency, another circle.
std::vector<Mark> offset_marks(const Rows& map, const Rows& centred);

double sum(const std::vector<Mark>& marks);   ///< of value times weight
double most(const std::vector<Mark>& marks);  ///< of weights

}  // namespace rubsweep::machine_search
