#include "rubsweep/dataset/machine_draw.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "dataset/small_study.hpp"

namespace rubsweep::dataset {
namespace {

TEST(MachineDraw, PartsHoldTheirSharesOfTheMachines) {
  DataStudy study = small_study();
  study.split = {0.5, 0.2, 0.3};
  constexpr std::size_t machines = 4000;
  std::map<std::string_view, int> count;
  for (std::size_t machine = 0; machine < machines; ++machine) ++count[draw_machine(study, machine).part];
  const std::map<std::string_view, double> shares{{"training", 0.5}, {"validation", 0.2}, {"test", 0.3}};
  ASSERT_EQ(count.size(), 3u);
  // Four standard deviations of a binomial distribution.
  for (const auto& [part, share] : shares)
    EXPECT_NEAR(count[part], machines * share, 4 * std::sqrt(machines * share * (1 - share))) << part;
}

TEST(MachineDraw, WholeShareIsEveryMachine) {
  DataStudy study = small_study();
  for (const auto& [split, part] : {std::pair<Split, std::string_view>{{1, 0, 0}, "training"},
                                    {{0, 1, 0}, "validation"},
                                    {{0, 0, 1}, "test"}}) {
    study.split = split;
    for (std::size_t machine = 0; machine < 100; ++machine)
      EXPECT_EQ(draw_machine(study, machine).part, part);
  }
}

TEST(MachineDraw, CandidatesTakeTurns) {
  for (std::size_t machine = 0; machine < 6; ++machine)
    EXPECT_EQ(candidate_of(small_study(), machine), machine % 2);
}

TEST(MachineDraw, ProbesHaveGainsOfTheirOwn) {
  DataStudy study = small_study();
  const MachineDraw both = draw_machine(study, 0);
  ASSERT_EQ(both.gain.size(), 2u);
  EXPECT_NE(both.gain[0], both.gain[1]);
  study.measurement.probes = 1;
  EXPECT_EQ(draw_machine(study, 0).gain.size(), 1u);
}

}  // namespace
}  // namespace rubsweep::dataset
