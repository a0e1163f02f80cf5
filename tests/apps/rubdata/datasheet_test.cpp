#include "rubdata/datasheet.hpp"

#include <gtest/gtest.h>

#include "measurement/dataset/small_study.hpp"
#include "rubsweep/measurement/dataset/labels.hpp"

namespace rubsweep::apps {
namespace {

TEST(Datasheet, NamesEveryColumnAndEveryRange) {
  const std::string text = datasheet(dataset::small_study(), "rubdata 0");
  for (const dataset::LabelColumn& column : dataset::label_columns())
    EXPECT_NE(text.find("| `" + std::string(column.name) + "` | "), std::string::npos) << column.name;
  EXPECT_NE(text.find("natural_frequency_hz: 25 to 35\n"), std::string::npos);
  EXPECT_NE(text.find("clearance_m: 1e-04 to 5e-04, evenly in the logarithm\n"), std::string::npos) << text;
  EXPECT_NE(text.find("6 recordings of 3 machines, made by rubdata 0"), std::string::npos);
}

TEST(Datasheet, SaysWhatTheSetIsMeasuredByAndHowToCiteIt) {
  const std::string text = datasheet(dataset::small_study(), "rubdata 0");
  for (const char* said : {"## Baseline\n", "## How to cite\n", "the version, rubdata 0, the study below"})
    EXPECT_NE(text.find(said), std::string::npos) << said;
}

TEST(Datasheet, OfOneProbeKnowsNoY) {
  dataset::DataStudy study = dataset::small_study();
  EXPECT_NE(datasheet(study, "").find("`y_m`"), std::string::npos);
  EXPECT_NE(instrument_yaml(study).find("y_m"), std::string::npos);
  study.measurement.probes = 1;
  EXPECT_EQ(datasheet(study, "").find("`y_m`"), std::string::npos);
  EXPECT_EQ(instrument_yaml(study).find("y_m"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::apps
