#include "bench/label_agreement.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/set_a_cell.hpp"

namespace rubsweep::bench {
namespace {

using scene::Place;

const std::array<Place, 4> places{Place{75, scene::WhirlRatio{0.4}}, Place{75, scene::WhirlRatio{1.2}},
                                  Place{90, scene::WhirlRatio{0.6}}, Place{54, scene::WhirlRatio{0.05}}};

/// At an undamped resonance no eccentricity gives the whirl ratio.
TEST(LabelAgreement, CellsThatCannotRunAreLeftOut) {
  model::Machine undamped = test::machine_of({});
  std::get<model::JeffcottRotor>(undamped.rotor).damping_ratio = 0;
  const std::array<Place, 3> some{Place{75, scene::WhirlRatio{0.4}}, Place{30, scene::WhirlRatio{0.4}},
                                  Place{54, scene::WhirlRatio{0.05}}};
  const auto cells = reference_labels(undamped, some, {}, {});
  ASSERT_EQ(cells.size(), 2);
  EXPECT_EQ(cells[1].place, 2);
}

TEST(LabelAgreement, CellsThatStartInContactCount) {
  const auto cells = reference_labels(test::machine_of({}), places, {}, {});
  ASSERT_EQ(cells.size(), 4);
  EXPECT_EQ(cells[2].label.motion_class, response::motion::MotionClass::subharmonic);
  EXPECT_EQ(cells[2].label.order, 2);
}

TEST(LabelAgreement, CountsEqualClassAndOrder) {
  auto cells = reference_labels(test::machine_of({}), places, {}, {});
  const LabelAgreement all = label_agreement(cells, {}, {}, 100);
  EXPECT_EQ(all.compared, 4);
  EXPECT_EQ(all.agreed, 4);
  EXPECT_FALSE(all.cut);
  cells[2].label.order = 3;
  EXPECT_EQ(label_agreement(cells, {}, {}, 100).agreed, 3);
}

TEST(LabelAgreement, WithoutTimeNothingIsCompared) {
  const auto cells = reference_labels(test::machine_of({}), places, {}, {});
  const LabelAgreement none = label_agreement(cells, {}, {}, 0);
  EXPECT_TRUE(none.cut);
  EXPECT_LT(none.compared, 4);
}

TEST(LabelAgreementSpread, TakesBothEndsAndEvenSteps) {
  EXPECT_EQ(spread(66, 4), (std::vector<std::size_t>{0, 22, 43, 65}));
  EXPECT_EQ(spread(3, 12), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(spread(5, 1), (std::vector<std::size_t>{2}));
  EXPECT_TRUE(spread(5, 0).empty());
  const auto twelve = spread(66, 12);
  EXPECT_EQ(twelve.front(), 0);
  EXPECT_EQ(twelve.back(), 65);
  for (std::size_t i = 1; i < twelve.size(); ++i) EXPECT_GE(twelve[i] - twelve[i - 1], 5);
}

}  // namespace
}  // namespace rubsweep::bench
