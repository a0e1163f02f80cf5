#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/study/study.hpp"

namespace rubsweep::config::study {
namespace {

RunConfig with_study(const std::string& study) {
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml",
                              {"kick={force_n: 200, duration_s: 0.005}", "study=" + study});
}

std::string study_problem(const std::string& study) {
  const std::string message =
      message_of(test_file("minimal.yaml"), {"kick={force_n: 200, duration_s: 0.005}", "study=" + study});
  return message.substr(message.rfind("}: ") + 3);
}

TEST(StudyKind, ReadsAThreshold) {
  const auto threshold =
      with_study("{kind: threshold, key: kick.force_n, values: [10, 20, 40]}").study.threshold;
  ASSERT_TRUE(threshold);
  EXPECT_EQ(threshold->axis.keys, std::vector<std::string>{"kick.force_n"});
  EXPECT_EQ(threshold->axis.values, (std::vector<double>{10, 20, 40}));
  EXPECT_EQ(threshold->tolerance, 1e-3);
}

TEST(StudyKind, IsPrintedAndCountsInTheDigest) {
  const RunConfig plain = read_run_config_text(test_file("minimal.yaml"), "test.yaml",
                                               {"kick={force_n: 200, duration_s: 0.005}"});
  const RunConfig scan =
      with_study("{kind: threshold, key: kick.force_n, from: 10, to: 40, count: 3, scale: log}");
  const RunConfig finer = with_study(
      "{kind: threshold, key: kick.force_n, from: 10, to: 40, count: 3, scale: log, tolerance: 1e-4}");
  EXPECT_NE(study_digest(plain.study), study_digest(scan.study));
  EXPECT_NE(study_digest(finer.study), study_digest(scan.study));
  EXPECT_EQ(print_config(read_run_config_text(print_config(finer), "printed", {})), print_config(finer));
}

TEST(StudyKind, ReadsAndPrintsBasins) {
  const RunConfig config = with_study(
      "{kind: basin, samples: 100, over: [{key: kick.force_n, from: 1, to: 400, scale: log}, "
      "{key: kick.angle_deg, from: 0, to: 360}]}");
  ASSERT_TRUE(config.study.basin);
  EXPECT_EQ(config.study.basin->samples, 100u);
  ASSERT_EQ(config.study.basin->over.size(), 2u);
  EXPECT_TRUE(config.study.basin->over[0].logarithmic);
  EXPECT_EQ(config.study.basin->over[1].to, 360);
  EXPECT_EQ(print_config(read_run_config_text(print_config(config), "printed", {})), print_config(config));
}

TEST(StudyKind, OfAMapIsThatOfNoStudy) {
  const RunConfig plain = read_run_config_text(test_file("minimal.yaml"), "test.yaml",
                                               {"kick={force_n: 200, duration_s: 0.005}"});
  EXPECT_EQ(print_config(with_study("{kind: map}")), print_config(plain));
}

TEST(StudyKind, RefusesBasinsThatCannotBeDrawn) {
  EXPECT_EQ(study_problem("{kind: basin, samples: 0, over: [{key: kick.force_n, from: 1, to: 400}]}"),
            "study.samples: 0 is out of range, allowed: an integer from 1 to 1000000");
  EXPECT_EQ(study_problem("{kind: basin, samples: 9, over: [{key: kick.force_n, from: -1, to: 400}]}"),
            "kick.force_n: -1 is out of range, allowed: a number >= 0");
  EXPECT_EQ(
      study_problem("{kind: basin, samples: 9, over: [{key: kick.force_n, from: 0, to: 4, scale: log}]}"),
      "study.over.0.scale: a logarithmic scale has no place for 0 or less, allowed: from and to > 0");
  EXPECT_EQ(study_problem("{kind: basin, samples: 9, over: [{key: kick.force_n, from: 0, to: 0}]}"),
            "study.over.0.to: is no other number than from, allowed: another number");
}

TEST(StudyKind, RefusesWhatIsNoScan) {
  EXPECT_EQ(study_problem("{kind: treshold}"),
            "study.kind: 'treshold' is unknown (did you mean 'threshold'?), allowed: threshold, basin, map");
  EXPECT_EQ(study_problem("{kind: threshold, key: kick.force_n, values: [20, 10]}"),
            "study.values: does not ascend, allowed: two values or more, each larger than the one before");
  EXPECT_EQ(
      study_problem("{kind: threshold, key: kick.force_n, from: 5, count: 1}"),
      "study.count: one value is no scan, allowed: two values or more, each larger than the one before");
  EXPECT_EQ(study_problem("{kind: threshold, key: kick.force_n, values: [-1, 10]}"),
            "kick.force_n: -1 is out of range, allowed: a number >= 0");
  EXPECT_EQ(study_problem("{kind: threshold, key: kick.force_n, values: [1, 10], tolerance: 0}"),
            "study.tolerance: 0 is out of range, allowed: a number >= 1e-12 and <= 0.5");
}

TEST(StudyKind, RefusesAKeyThatAnAxisVaries) {
  const std::string axis =
      "sweep={speed_hz: {values: [60]}, whirl_ratio: {values: [0.5]}, x: {key: kick.force_n, values: [1]}}";
  for (const std::string study : {"{kind: threshold, key: kick.force_n, values: [1, 10]}",
                                  "{kind: basin, samples: 9, over: [{key: kick.force_n, from: 0, to: 4}]}"}) {
    const std::string message = message_of(
        test_file("minimal.yaml"), {"kick={force_n: 200, duration_s: 0.005}", axis, "study=" + study});
    EXPECT_NE(
        message.find("kick.force_n: is varied by an axis of the sweep as well, allowed: one of the two"),
        std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace rubsweep::config::study
