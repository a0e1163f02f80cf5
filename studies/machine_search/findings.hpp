#pragma once

#include <string_view>
#include <vector>

#include "machine_search/candidate.hpp"
#include "machine_search/domains.hpp"

namespace rubsweep::machine_search {

/// Degree to which a map shows one finding of the paper, by the measures of scripts/analysis/findings_*.py.
struct Mark {
  std::string_view finding;
  double verdict = 0;   ///< 1: holds, 0.5: partly, 0: not reproduced
  double nearness = 0;  ///< the deciding share, from 0 to 1, which guides the search
};

/// Marks of the map with one stop: each 1/n lies above n times the natural frequency and leans, larger n
/// needs less unbalance, the motions of figure 7 occur, gaps exist, only 1/n occurs, and the rotor stays
/// near.
std::vector<Mark> one_side_marks(const Rows& map);

/// Marks of two stops with equal casings: synchronous motion over a wide range, subharmonics only at small
/// unbalance and only of odd order, nothing else.
std::vector<Mark> both_sides_marks(const Rows& map);

/// Marks of two stops at unequal distances: even orders, including motions with one impact in n turns, which
/// touch only one side.
std::vector<Mark> unequal_casings_marks(const Rows& map, const Rows& equal);

/// Marks of the centred annulus: circles at low speed, ovals at high speed, the latter at smaller unbalance
/// and with several impacts per whirl, nothing else.
std::vector<Mark> annulus_marks(const Rows& map);

/// Marks of the offset annulus: circles up to a higher speed, 1/n slightly above n, nothing else. Rows i of
/// the map `centred` have the same unbalance.
std::vector<Mark> offset_marks(const Rows& map, const Rows& centred);

/// Marks for plausible values of a test rig: a contact of at most 1e7 N/m, and no rub beyond ten clearances
/// in any of these maps.
std::vector<Mark> plausible_marks(const Candidate& candidate, const std::vector<const Rows*>& maps);

/// Sum of the verdicts plus a tenth of the nearness, which is never larger than one verdict.
double score(const std::vector<Mark>& marks);

}  // namespace rubsweep::machine_search
