#include "rubsweep/config/study_kind.hpp"

#include "config/support.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/study_digest.hpp"

namespace rubsweep::config {
namespace {

RunConfig with(const std::string& study) {
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml",
                              {"kick={force_n: 200, duration_s: 0.005}", "study=" + study});
}

std::string problem(const std::string& study) {
  const std::string message =
      message_of(test_file("minimal.yaml"), {"kick={force_n: 200, duration_s: 0.005}", "study=" + study});
  return message.substr(message.rfind("}: ") + 3);
}

TEST(StudyKind, ReadsAThreshold) {
  const auto threshold = with("{kind: threshold, key: kick.force_n, values: [10, 20, 40]}").study.threshold;
  ASSERT_TRUE(threshold);
  EXPECT_EQ(threshold->axis.keys, std::vector<std::string>{"kick.force_n"});
  EXPECT_EQ(threshold->axis.values, (std::vector<double>{10, 20, 40}));
  EXPECT_EQ(threshold->tolerance, 1e-3);
}

TEST(StudyKind, IsPrintedAndCountsInTheDigest) {
  const RunConfig plain = read_run_config_text(test_file("minimal.yaml"), "test.yaml",
                                               {"kick={force_n: 200, duration_s: 0.005}"});
  const RunConfig scan = with("{kind: threshold, key: kick.force_n, from: 10, to: 40, count: 3, scale: log}");
  const RunConfig finer =
      with("{kind: threshold, key: kick.force_n, from: 10, to: 40, count: 3, scale: log, tolerance: 1e-4}");
  EXPECT_NE(study_digest(plain.study), study_digest(scan.study));
  EXPECT_NE(study_digest(finer.study), study_digest(scan.study));
  EXPECT_EQ(print_config(read_run_config_text(print_config(finer), "printed", {})), print_config(finer));
}

TEST(StudyKind, RefusesWhatIsNoScan) {
  EXPECT_EQ(problem("{kind: treshold}"),
            "study.kind: 'treshold' is unknown (did you mean 'threshold'?), allowed: threshold");
  EXPECT_EQ(problem("{kind: threshold, key: kick.force_n, values: [20, 10]}"),
            "study.values: does not ascend, allowed: two values or more, each larger than the one before");
  EXPECT_EQ(
      problem("{kind: threshold, key: kick.force_n, from: 5, count: 1}"),
      "study.count: one value is no scan, allowed: two values or more, each larger than the one before");
  EXPECT_EQ(problem("{kind: threshold, key: kick.force_n, values: [-1, 10]}"),
            "kick.force_n: -1 is out of range, allowed: a number >= 0");
  EXPECT_EQ(problem("{kind: threshold, key: kick.force_n, values: [1, 10], tolerance: 0}"),
            "study.tolerance: 0 is out of range, allowed: a number >= 1e-12 and <= 0.5");
}

}  // namespace
}  // namespace rubsweep::config
