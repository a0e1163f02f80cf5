#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "rubsweep/core/error.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

TEST(StepperTable, EveryRowIsFoundByItsStepperAndHasAWordOfItsOwn) {
  std::set<std::string_view> words;
  for (const StepperRow& row : stepper_table()) {
    EXPECT_EQ(&row_of(row.stepper), &row);
    EXPECT_TRUE(words.insert(row.word).second) << row.word;
    EXPECT_NE(row.make, nullptr) << row.word;
  }
  EXPECT_TRUE(words.contains("dopri5"));
  EXPECT_EQ(row_of(run::SolverOptions{}.stepper).word, "auto");
}

TEST(StepperTable, SingleSteppersAreAllButAutomaticAndSayTheirName) {
  ASSERT_EQ(single_steppers().size() + 1, stepper_table().size());
  for (const run::Stepper stepper : single_steppers()) {
    EXPECT_NE(stepper, run::Stepper::automatic);
    EXPECT_TRUE(row_of(stepper).description.starts_with(row_of(stepper).word)) << row_of(stepper).word;
  }
}

TEST(StepperTable, ANumberThatIsNoStepperIsAFaultOfTheProgram) {
  EXPECT_THROW(row_of(static_cast<run::Stepper>(stepper_table().size())), SolverError);
  EXPECT_THROW(row_of(static_cast<run::Stepper>(-1)), SolverError);
}

}  // namespace
}  // namespace rubsweep::integrate::adaptive
