#include "rubsweep/maps/sweep/threshold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

ThresholdScan scan(std::vector<double> values, double tolerance = 1e-3) {
  return {{{"kick.force_n"}, {1}, std::move(values)}, tolerance};
}

TEST(Threshold, FindsEveryIntervalWithItsMotions) {
  const double begin = 31.41592, gap = 271.8281828, back = 577.21566;
  const auto threshold = find_threshold(scan({10, 50, 100, 200, 300, 400, 600, 800}), [&](double value) {
    if (value < begin || (value >= gap && value < back)) return Probe{false, false, "non_contact"};
    return Probe{true, false, value < 150 ? "subharmonic 1/2" : "chaotic"};
  });
  ASSERT_EQ(threshold.intervals.size(), 2u);
  const auto near = [](double found, double wanted) {
    EXPECT_LE(std::abs(found / wanted - 1), 1e-3) << found;
  };
  near(threshold.intervals[0].from, begin);
  EXPECT_GE(threshold.intervals[0].from, begin);
  near(threshold.intervals[0].to, gap);
  EXPECT_LT(threshold.intervals[0].to, gap);
  EXPECT_EQ(threshold.intervals[0].motions, (std::vector<std::string>{"subharmonic 1/2", "chaotic"}));
  near(threshold.intervals[1].from, back);
  EXPECT_EQ(threshold.intervals[1].to, 800);
  EXPECT_EQ(threshold.intervals[1].motions, std::vector<std::string>{"chaotic"});
}

TEST(Threshold, TriesNothingTwiceAndNoMoreThanBisectionNeeds) {
  std::vector<double> tried;
  const auto threshold = find_threshold(scan({1, 2, 4, 8}), [&](double value) {
    EXPECT_EQ(std::ranges::count(tried, value), 0);
    tried.push_back(value);
    return Probe{value > 3, false, "chaotic"};
  });
  EXPECT_EQ(threshold.probes, tried.size());
  EXPECT_EQ(tried.size(), 4 + 10u);  // a factor of 2 within 1e-3: ln 2 / 1e-3 < 2^10
}

TEST(Threshold, HasNoIntervalWhereNothingRubs) {
  const auto threshold = find_threshold(scan({1, 2}), [](double) {
    return Probe{false, false, "non_contact"};
  });
  EXPECT_TRUE(threshold.intervals.empty());
  EXPECT_EQ(threshold.probes, 2u);
}

TEST(Threshold, CountsWhatFailedAsNotRubbing) {
  const auto threshold = find_threshold(scan({1, 2, 3}, 0.4), [](double value) {
    return Probe{value > 2.5, value<1.5, value> 2.5 ? "synchronous" : "failed"};
  });
  EXPECT_EQ(threshold.failed, 1u);
  ASSERT_EQ(threshold.intervals.size(), 1u);
}

TEST(Threshold, EndsAboutZeroToo) {
  const auto threshold = find_threshold(scan({-180, 0, 180}), [](double value) {
    return Probe{value >= 0, false, "synchronous"};
  });
  EXPECT_EQ(threshold.intervals.at(0).from, 0);
  EXPECT_LT(threshold.probes, 40u);
}

/// The same cell simulated alone, with the force in its machine.
TEST(Threshold, OfACellIsWhereItsOwnRunChanges) {
  Study study = one_side_study({75}, {0.4});
  study.response.max_revolutions = 400;
  study.threshold = scan({10, 20, 40, 80});
  study.with_keys = [machine = study](std::span<const KeyValue> keys) {
    Study varied = machine;
    for (const KeyValue& key : keys) {
      EXPECT_EQ(key.key, "kick.force_n");
      varied.machine.kick->force_n = key.value;
    }
    return varied;
  };
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  ASSERT_TRUE(row.threshold);
  ASSERT_FALSE(row.threshold->intervals.empty());
  const RubInterval& first = row.threshold->intervals.front();
  EXPECT_GT(first.from, 10);
  const auto motion_after = [&](double force_n) {
    Study own = one_side_study({75}, {0.4});
    own.response.max_revolutions = 400;
    own.machine.kick->force_n = force_n;
    return class_and_order(evaluate_cell(own, 0, workspace));
  };
  EXPECT_EQ(motion_after(first.from), first.motions.front());
  EXPECT_EQ(motion_after(first.from * (1 - 1e-3)), "non_contact");
}

/// Values for two keys, one of which changes the structure.
Study with_force_and_frequency(const Study& study, std::span<const KeyValue> keys) {
  Study varied = study;
  for (const KeyValue& key : keys) {
    if (key.key == "kick.force_n") varied.machine.kick->force_n = key.value;
    if (key.key == "rotor.natural_frequency_hz")
      std::get<model::JeffcottRotor>(varied.machine.rotor).natural_frequency_hz = key.value;
  }
  return varied;
}

Threshold threshold_at(const Study& study, std::size_t cell) {
  response::motion::Workspace workspace;
  return evaluate_cell(study, cell, workspace).threshold.value();
}

void expect_equal(const Threshold& a, const Threshold& b) {
  EXPECT_EQ(a.probes, b.probes);
  ASSERT_EQ(a.intervals.size(), b.intervals.size());
  for (std::size_t i = 0; i < a.intervals.size(); ++i) {
    EXPECT_EQ(a.intervals[i].from, b.intervals[i].from);
    EXPECT_EQ(a.intervals[i].to, b.intervals[i].to);
    EXPECT_EQ(a.intervals[i].motions, b.intervals[i].motions);
  }
}

/// Kicks are tried on the structure that belongs to the cell's own keys.
TEST(Threshold, OfACellWithKeysOfItsOwnIsThatOfItsMachine) {
  Study plain = one_side_study({75}, {0.4});
  plain.response.max_revolutions = 200;
  plain.threshold = scan({20, 80, 200}, 0.1);
  Study study = plain;
  study.grid.axes = {{{"rotor.natural_frequency_hz"}, {1}, {30, 33}}};
  plain.with_keys = [plain](std::span<const KeyValue> keys) { return with_force_and_frequency(plain, keys); };
  study.with_keys = plain.with_keys;
  const Threshold other = threshold_at(study, 1);
  expect_equal(threshold_at(study, 0), threshold_at(plain, 0));
  Study own = with_force_and_frequency(plain, std::vector{KeyValue{"rotor.natural_frequency_hz", 33}});
  own.with_keys = [own](std::span<const KeyValue> keys) { return with_force_and_frequency(own, keys); };
  expect_equal(other, threshold_at(own, 0));
  ASSERT_FALSE(other.intervals.empty());
  EXPECT_NE(other.intervals.front().from, threshold_at(plain, 0).intervals.front().from);
}

/// If the number changes the structure, the structure is assembled again for every value.
TEST(Threshold, OfANumberOfTheRotorIsWhereItsOwnRunChanges) {
  Study study = one_side_study({75}, {0.4});
  study.response.max_revolutions = 200;
  study.threshold = scan({20, 40}, 0.1);
  study.threshold->axis.keys = {"rotor.natural_frequency_hz"};
  study.with_keys = [plain = study](std::span<const KeyValue> keys) {
    return with_force_and_frequency(plain, keys);
  };
  response::motion::Workspace workspace;
  for (const RubInterval& interval : threshold_at(study, 0).intervals) {
    Study own = with_force_and_frequency(one_side_study({75}, {0.4}),
                                         std::vector{KeyValue{"rotor.natural_frequency_hz", interval.from}});
    own.response.max_revolutions = 200;
    EXPECT_EQ(class_and_order(evaluate_cell(own, 0, workspace)), interval.motions.front());
  }
}

TEST(Threshold, OfAKickIsNotAskedForWhereNoneIsSimulated) {
  Study study = one_side_study({75}, {1.2});
  study.threshold = scan({10, 20});
  study.with_keys = [](std::span<const KeyValue>) -> Study {
    ADD_FAILURE() << "nothing to try";
    return {};
  };
  response::motion::Workspace workspace;
  EXPECT_FALSE(evaluate_cell(study, 0, workspace).threshold);
}

}  // namespace
}  // namespace rubsweep::sweep
