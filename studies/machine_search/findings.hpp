#pragma once

#include <string_view>
#include <vector>

#include "machine_search/candidate.hpp"
#include "machine_search/domains.hpp"

namespace rubsweep::machine_search {

/// How far a map shows one finding of the paper, by the measures of scripts/analysis/findings_*.py.
struct Mark {
  std::string_view finding;
  double verdict = 0;   ///< 1 holds, 0.5 partly, 0 not reproduced
  double nearness = 0;  ///< 0 to 1: the share that decides, which gives the search a direction
};

/// Marks of the map of one stop: each order above n and leaning, larger n from smaller unbalance, the motions
/// of figure 7, gaps, nothing but 1/n, the rotor stays near.
std::vector<Mark> one_side_marks(const Rows& map);

/// Marks of two stops with equal casings: synchronous over a wide range, subharmonics at small unbalance
/// alone and of odd order alone, nothing else.
std::vector<Mark> both_sides_marks(const Rows& map);

/// Marks of two stops of unequal distance: even orders, among them motions of one hit in n turns, which touch
/// one side only.
std::vector<Mark> unequal_casings_marks(const Rows& map, const Rows& equal);

/// Marks of the centred annulus: a circle at low speed, an oval at high speed, from smaller unbalance and
/// hitting several times a whirl, nothing else.
std::vector<Mark> annulus_marks(const Rows& map);

/// Marks of the offset annulus, beside the map `centred` whose rows i have the same unbalance: the circle to
/// higher speed, 1/n slightly above n, nothing else.
std::vector<Mark> offset_marks(const Rows& map, const Rows& centred);

/// Marks of what a kit may have: a contact of 1e7 N/m at most, no rub beyond ten clearances in any of these
/// maps.
std::vector<Mark> plausible_marks(const Candidate& candidate, const std::vector<const Rows*>& maps);

/// Verdicts, and a tenth of the nearness: no sum of those outweighs a verdict.
double score(const std::vector<Mark>& marks);

}  // namespace rubsweep::machine_search
