#include "rubsweep/analysis/design/design_terms.hpp"

#include <gtest/gtest.h>

namespace rubsweep::design {
namespace {

DesignCheck quiet_check() {
  DesignCheck check;
  check.vibration_limit_m = 2e-5;
  check.probes = {{0.25, {50, 1e-5}}};
  check.clearances = {{0, {}, 30, 3e-5, 2e-4, 0.8}};
  return check;
}

Term told(std::optional<bool> met, std::string not_told = {}) {
  Term term{"separation", "", {}, 30};
  term.met = met;
  term.not_told = std::move(not_told);
  return term;
}

TEST(DesignTerms, ABrokenLimitCountsBeforeOneThatIsNotTold) {
  DesignCheck check = quiet_check();
  EXPECT_EQ(answer_of(check), Answer::pass);
  check.lateral = {told(true), told({})};
  EXPECT_EQ(answer_of(check), Answer::pass) << "a term without a limit";
  check.lateral.push_back(told({}, "tables end"));
  EXPECT_EQ(answer_of(check), Answer::not_told);
  check.lateral.push_back(told(false));
  EXPECT_EQ(answer_of(check), Answer::not_met);
}

TEST(DesignTerms, NothingPassesWhereAMotionBelowTheOperatingRangeGrows) {
  DesignCheck check = quiet_check();
  check.whole_growth = {30, 5};
  EXPECT_EQ(answer_of(check), Answer::not_told);
}

TEST(DesignTerms, OfARotorThatGrowsAreNotMet) {
  DesignCheck check = quiet_check();
  check.growth = check.whole_growth = {140, 201};
  EXPECT_EQ(answer_of(check), Answer::not_met);
  for (const Term& term : terms_of(check)) {
    EXPECT_NE(term.met, std::optional(true)) << term.check;
  }
}

}  // namespace
}  // namespace rubsweep::design
