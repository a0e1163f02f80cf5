#include "rubsweep/measurement/diagnose/inference/kept_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "maps/batch/temporary_directory.hpp"
#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

namespace fs = std::filesystem;

class KeptCases : public testing::Test {
 protected:
  fs::path only_file() const { return fs::directory_iterator(directory_.path())->path(); }

  TemporaryDirectory directory_;
  std::string digest_ = cases_digest(small_problem(), few_cases());
};

TEST_F(KeptCases, AreTheSameAgain) {
  keep_cases(directory_.path(), digest_, small_set());
  const auto again = kept_cases(directory_.path(), digest_, small_problem());
  ASSERT_TRUE(again);
  ASSERT_EQ(again->cases.size(), small_set().cases.size());
  for (std::size_t i = 0; i < again->cases.size(); ++i) {
    const SimulatedCase &one = again->cases[i], &kept = small_set().cases[i];
    EXPECT_EQ(one.candidate, kept.candidate);
    EXPECT_EQ(one.unit, kept.unit);
    ASSERT_EQ(one.motion.lines.last(), kept.motion.lines.last());
    for (int k = -kept.motion.lines.last(); k <= kept.motion.lines.last(); ++k)
      ASSERT_EQ(one.motion.lines.at(k), kept.motion.lines.at(k)) << k;
    EXPECT_EQ(one.motion.eccentricity_m, kept.motion.eccentricity_m);
    EXPECT_EQ(one.motion.contact.contact_fraction, kept.motion.contact.contact_fraction);
    EXPECT_EQ(one.motion.contact.peak_contact_force_n, kept.motion.contact.peak_contact_force_n);
  }
}

TEST_F(KeptCases, OfAnotherMachineAreNotTaken) {
  keep_cases(directory_.path(), digest_, small_set());
  DiagnosisProblem other = small_problem();
  other.fixed.rotor_mass_kg = 2;
  EXPECT_FALSE(kept_cases(directory_.path(), cases_digest(other, few_cases()), other));
  // The instrument does not affect the simulated motions.
  other = small_problem();
  other.measuring.probes = 1;
  EXPECT_EQ(cases_digest(other, few_cases()), digest_);
}

TEST_F(KeptCases, ThatAreDamagedAreNotTaken) {
  keep_cases(directory_.path(), digest_, small_set());
  std::ifstream in(only_file(), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  for (const std::size_t length : {std::size_t{0}, std::size_t{40}, bytes.size() / 2, bytes.size() - 1}) {
    std::ofstream(only_file(), std::ios::binary) << bytes.substr(0, length);
    EXPECT_FALSE(kept_cases(directory_.path(), digest_, small_problem())) << length;
  }
  std::string flipped = bytes;
  flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 1);
  std::ofstream(only_file(), std::ios::binary) << flipped;
  EXPECT_FALSE(kept_cases(directory_.path(), digest_, small_problem()));
}

TEST_F(KeptCases, ServeSpeedsNearby) {
  EXPECT_EQ(simulated_speed_hz(70.01), simulated_speed_hz(70.05));
  for (const double speed_hz : {3.0, 29.9, 70.0, 411.0})
    EXPECT_LT(std::abs(simulated_speed_hz(speed_hz) / speed_hz - 1), 0.0026);
}

TEST_F(KeptCases, OfARunUpHaveTheMotionsAtAllSpeeds) {
  DiagnosisProblem run_up = small_problem();
  run_up.further_speeds_hz = {50, 80};
  const std::string digest = cases_digest(run_up, few_cases());
  EXPECT_NE(digest, digest_);
  CaseSet set{{small_set().cases[0], small_set().cases[30]}};
  for (SimulatedCase& one : set.cases) one.further = {small_set().cases[1].motion.lines, one.motion.lines};
  keep_cases(directory_.path(), digest, set);
  const auto again = kept_cases(directory_.path(), digest, run_up);
  ASSERT_TRUE(again);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(again->cases[i].further.at(k).amplitude, set.cases[i].further[k].amplitude);
  // The same file does not serve a run-up of one further speed.
  run_up.further_speeds_hz.pop_back();
  EXPECT_FALSE(kept_cases(directory_.path(), digest, run_up));
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
