#include "rubsweep/measurement/dataset/datasheet.hpp"

#include <gtest/gtest.h>

#include "measurement/dataset/small_study.hpp"
#include "rubsweep/measurement/dataset/labels.hpp"

namespace rubsweep::dataset {
namespace {

TEST(Datasheet, NamesEveryColumnAndEveryRange) {
  const std::string text = datasheet(small_study(), "rubdata 0");
  for (const LabelColumn& column : label_columns())
    EXPECT_NE(text.find("| `" + std::string(column.name) + "` | "), std::string::npos) << column.name;
  EXPECT_NE(text.find("natural_frequency_hz: 25 to 35\n"), std::string::npos);
  EXPECT_NE(text.find("clearance_m: 1e-04 to 5e-04, evenly in the logarithm\n"), std::string::npos) << text;
  EXPECT_NE(text.find("6 recordings of 3 machines, made by rubdata 0"), std::string::npos);
}

TEST(Datasheet, StudyTextTellsStudiesApartButNotDirectories) {
  const DataStudy study = small_study();
  DataStudy other = study;
  other.directory = "elsewhere";
  EXPECT_EQ(study_text(other), study_text(study));
  other.seed = 2;
  EXPECT_NE(study_text(other), study_text(study));
  other = study;
  spread_of(other.candidates[1], diagnose::Unknown::restitution).high = 0.9;
  EXPECT_NE(study_text(other), study_text(study));
  other = study;
  other.measurement.gain_error = 0;
  EXPECT_NE(study_text(other), study_text(study));
  other = study;
  other.candidates[1].name = "pin";
  EXPECT_NE(study_text(other), study_text(study));
}

TEST(Datasheet, OfOneProbeKnowsNoY) {
  DataStudy study = small_study();
  EXPECT_NE(datasheet(study, "").find("`y_m`"), std::string::npos);
  EXPECT_NE(instrument_yaml(study).find("y_m"), std::string::npos);
  study.measurement.probes = 1;
  EXPECT_EQ(datasheet(study, "").find("`y_m`"), std::string::npos);
  EXPECT_EQ(instrument_yaml(study).find("y_m"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::dataset
