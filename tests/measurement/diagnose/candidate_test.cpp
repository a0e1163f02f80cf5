#include "rubsweep/measurement/diagnose/candidate.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rubsweep::diagnose {
namespace {

TEST(Candidate, UsualRangesAreOfNumbersThatAMachineMayHave) {
  for (const Candidate& candidate : usual_candidates()) {
    for (const UnknownRow& row : unknown_rows()) {
      const Spread& spread = spread_of(candidate, row.unknown);
      EXPECT_LE(spread.low, spread.high) << row.key;
      // Equal bounds mark numbers that the stops do not have; these need not be in the range.
      if (!row.of_file || spread.low == spread.high) continue;
      EXPECT_TRUE(model::contains(row.range, spread.low)) << row.key;
      EXPECT_TRUE(model::contains(row.range, spread.high)) << row.key;
    }
  }
}

TEST(Candidate, RowsStandInTheOrderOfTheirUnknowns) {
  for (std::size_t i = 0; i < unknown_count; ++i)
    EXPECT_EQ(static_cast<std::size_t>(unknown_rows()[i].unknown), i);
}

TEST(Candidate, NumbersOfOtherStopsAreKnown) {
  const Candidate flat = usual_candidate(Cause::one_side);
  for (const Unknown other : {Unknown::offset_ratio, Unknown::second_clearance_ratio})
    EXPECT_EQ(spread_of(flat, other).low, spread_of(flat, other).high);
  EXPECT_LT(spread_of(usual_candidate(Cause::two_sides), Unknown::second_clearance_ratio).low, 1);
  EXPECT_GT(spread_of(usual_candidate(Cause::annular_offset), Unknown::offset_ratio).high, 0.5);
}

TEST(Candidate, UsualOnesHaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Candidate& candidate : usual_candidates()) names.insert(candidate.name);
  EXPECT_EQ(names, (std::set<std::string>{"no_rub", "one_side", "two_sides", "annular", "annular_offset"}));
}

TEST(Candidate, NoRubIsTwiceAsLikelyAsAllRubsTogether) {
  const std::vector<double> prior = usual_prior(usual_candidates());
  ASSERT_EQ(prior.size(), all_causes.size());
  for (std::size_t c = 0; c < prior.size(); ++c) {
    const bool flat_stop = all_causes[c] == Cause::one_side || all_causes[c] == Cause::two_sides;
    EXPECT_DOUBLE_EQ(prior[c], all_causes[c] == Cause::no_rub ? 2.0 / 3 : flat_stop ? 1.0 / 9 : 1.0 / 18);
  }
  const Candidate flat = usual_candidate(Cause::one_side), quiet = usual_candidate(Cause::no_rub);
  EXPECT_EQ(usual_prior({flat, flat}), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(usual_prior({quiet, quiet, quiet, quiet}), (std::vector<double>(4, 0.25)));
}

TEST(Candidate, CentredAndOffsetRoundStopsAreOneKind) {
  const Candidate flat = usual_candidate(Cause::one_side), centred = usual_candidate(Cause::annular),
                  offset = usual_candidate(Cause::annular_offset);
  EXPECT_EQ(usual_prior({flat, centred, offset}), (std::vector<double>{0.5, 0.25, 0.25}));
  EXPECT_EQ(usual_prior({flat, offset}), (std::vector<double>{0.5, 0.5}));
}

TEST(Candidate, CornersOfTheUnitCubeAreTheBounds) {
  const Candidate candidate = usual_candidate(Cause::two_sides);
  Point low{}, high{};
  high.fill(1);
  for (std::size_t i = 0; i < unknown_count; ++i) {
    EXPECT_DOUBLE_EQ(values_at(candidate, low)[i], candidate.spreads[i].low);
    EXPECT_DOUBLE_EQ(values_at(candidate, high)[i], candidate.spreads[i].high);
  }
}

}  // namespace
}  // namespace rubsweep::diagnose
