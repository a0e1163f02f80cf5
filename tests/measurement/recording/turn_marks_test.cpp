#include "rubsweep/measurement/recording/turn_marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "measurement/recording/shaft_marks.hpp"

namespace rubsweep::recording {
namespace {

TEST(TurnMarks, MissingMarksAreFilledAndThoseTooManyDropped) {
  const auto truth = turns_s(60, 30, 2);
  auto marks = truth;
  marks.erase(marks.begin() + 40);
  marks.erase(marks.begin() + 20, marks.begin() + 22);
  marks.insert(marks.begin() + 11, (truth[10] * 2 + truth[11]) / 3);
  const TurnMarks numbered = numbered_marks(marks);
  EXPECT_EQ(numbered.filled, 3);
  EXPECT_EQ(numbered.dropped, 1);
  ASSERT_EQ(numbered.t_s.size(), truth.size());
  EXPECT_LT(largest_error(numbered.t_s, truth), 1e-6);
  const TurnMarks untouched = numbered_marks(truth);
  EXPECT_EQ(untouched.t_s, truth);
  EXPECT_EQ(untouched.filled + untouched.dropped, 0);
}

TEST(TurnMarks, ARunUpFromRestHasNoMissingMarks) {
  std::vector<double> marks;
  for (int n = 1; n < 50; ++n) marks.push_back(std::sqrt(2.0 * n / 4));
  EXPECT_EQ(numbered_marks(marks).t_s, marks);
}

TEST(TurnMarks, ManyMarksTooManyAreFound) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  int wrong = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto truth = turns_s(40, 47, 3 * uniform(random));
    auto marks = truth;
    // A mark too many in seven turns of ten, and marks that jitter by a four-hundredth of a turn.
    for (double& mark : marks) mark += 1e-4 * (uniform(random) - 0.5);
    const auto true_marks = marks;
    for (std::size_t k = 0; k + 1 < truth.size(); ++k)
      if (uniform(random) < 0.7) marks.push_back(truth[k] + uniform(random) * (truth[k + 1] - truth[k]));
    std::ranges::sort(marks);
    const TurnMarks numbered = numbered_marks(marks);
    if (numbered.t_s.size() != truth.size() || largest_error(numbered.t_s, true_marks) > 1e-3) ++wrong;
  }
  EXPECT_LE(wrong, 1);
}

TEST(TurnMarks, AMarkThatIsThereTwiceEveryTurnCountsOnce) {
  std::vector<double> marks;
  for (const double t_s : turns_s(30, 50, 0)) {
    marks.push_back(t_s);
    marks.push_back(t_s + 0.3 * 0.02);
  }
  const TurnMarks numbered = numbered_marks(marks);
  EXPECT_EQ(numbered.dropped, 30);
  EXPECT_EQ(numbered.t_s.size(), 30u);
}

TEST(TurnMarks, ALongGapIsCounted) {
  auto marks = turns_s(80, 50, 0.2);
  const auto truth = marks;
  marks.erase(marks.begin() + 20, marks.begin() + 45);
  EXPECT_LT(largest_error(numbered_marks(marks).t_s, truth), 1e-3);
}

}  // namespace
}  // namespace rubsweep::recording
