#include "rubsweep/core/integrate/run/turn_book.hpp"

#include <gtest/gtest.h>

namespace rubsweep::integrate::run {
namespace {

TEST(TurnBook, TheSumOfTwoEffortsHoldsEveryMember) {
  const auto counted = [](long from) {
    Effort effort;
    auto& [rhs_calls, steps, refused, switches, implicit_steps, taylor_turns, taylor_pieces, creep_pieces,
           taylor_work, adaptive_turns] = effort;
    for (long* member : {&rhs_calls, &steps, &refused, &switches, &implicit_steps, &taylor_turns,
                         &taylor_pieces, &creep_pieces, &adaptive_turns})
      *member = from++;
    taylor_work = static_cast<double>(from) + 0.5;
    return effort;
  };
  const Effort all = counted(1) + counted(100);
  EXPECT_EQ(all.rhs_calls, 101);
  EXPECT_EQ(all.steps, 103);
  EXPECT_EQ(all.refused, 105);
  EXPECT_EQ(all.switches, 107);
  EXPECT_EQ(all.implicit_steps, 109);
  EXPECT_EQ(all.taylor_turns, 111);
  EXPECT_EQ(all.taylor_pieces, 113);
  EXPECT_EQ(all.creep_pieces, 115);
  EXPECT_EQ(all.adaptive_turns, 117);
  EXPECT_EQ(all.taylor_work, 10.5 + 109.5);
}

TEST(TurnBook, StepsThatAreRefusedCountAgainstTheLimit) {
  TurnBook book;
  book.effort.steps = 40;
  book.limit_steps(3);
  ++book.effort.steps;
  book.refuse_step();
  EXPECT_TRUE(book.may_step());
  book.refuse_step();
  EXPECT_FALSE(book.may_step());
  EXPECT_EQ(book.effort.refused, 2);
  book.limit_steps(1);
  EXPECT_TRUE(book.may_step());
}

TEST(TurnBook, StandsStillAfterSixteenChangesWithoutProgress) {
  TurnBook book;
  for (int k = 0; k < 16; ++k) {
    EXPECT_FALSE(book.stands_still());
    book.note_progress(false);
    EXPECT_FALSE(book.made_progress());
  }
  EXPECT_TRUE(book.stands_still());
  book.note_progress(true);
  EXPECT_FALSE(book.stands_still());
  EXPECT_TRUE(book.made_progress());
  for (int k = 0; k < 16; ++k) book.note_progress(false);
  book.begin_turn({});
  EXPECT_FALSE(book.stands_still());
}

TEST(TurnBook, CountsEveryChangeOfModeAndListsThoseThatAreAskedFor) {
  TurnBook book;
  TurnReport report;
  const ModeSwitch begins{1.5, 0, contact::Mode::open, contact::Mode::sprung};
  const ModeSwitch ends{2.5, 0, contact::Mode::sprung, contact::Mode::open};
  book.begin_turn({});
  book.note_switch(begins, report);
  EXPECT_TRUE(report.switches.empty());
  book.begin_turn({.switches = true});
  book.note_switch(ends, report);
  ASSERT_EQ(report.switches.size(), 1u);
  EXPECT_EQ(report.switches[0].phase_rad, 2.5);
  EXPECT_EQ(report.hits, 1);
  EXPECT_EQ(book.effort.switches, 2);
}

TEST(TurnBook, ATurnInContactAllAlongIsOneTurnInContact) {
  TurnBook book;
  TurnReport report;
  for (int k = 0; k < 10; ++k) add_contact(0.1 + 1e-9, report);
  book.end_turn(true, report);
  EXPECT_EQ(report.contact_fraction, 1);
  EXPECT_TRUE(report.touched);
  EXPECT_TRUE(report.touching_at_end);
  EXPECT_EQ(book.revolution, 1);
}

}  // namespace
}  // namespace rubsweep::integrate::run
