#include "rubsweep/analysis/branch/journal/family_journal.hpp"

#include <gtest/gtest.h>

#include "maps/map/small_map.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/map/map_files.hpp"

namespace rubsweep::branch::journal {
namespace {

TEST(FamilyJournal, GoesOnWithWhatAnInterruptedCallLeft) {
  const map::SmallMap map;
  const sweep::Study study = map::SmallMap::config().study;
  FamilyJournal(map.path, study, false).records().keep_stays(1, 2, true);
  FamilyJournal again(map.path, study, false);
  EXPECT_EQ(again.found_before(), 1u);
  EXPECT_EQ(again.records().stays(1, 2), true);
  EXPECT_EQ(again.records().stays(1, 3), std::nullopt);
}

TEST(FamilyJournal, ForgetsItWhenFreshAndRemovesIt) {
  const map::SmallMap map;
  const sweep::Study study = map::SmallMap::config().study;
  FamilyJournal(map.path, study, false).records().keep_stays(1, 2, true);
  FamilyJournal fresh(map.path, study, true);
  EXPECT_EQ(fresh.found_before(), 0u);
  EXPECT_TRUE(std::filesystem::exists(map.path / map::family_journal_file));
  fresh.remove();
  EXPECT_FALSE(std::filesystem::exists(map.path / map::family_journal_file));
}

TEST(FamilyJournal, RefusesThatOfAnotherStudy) {
  const map::SmallMap map;
  FamilyJournal(map.path, map::SmallMap::config().study, false).records().keep_stays(1, 2, true);
  EXPECT_THROW(FamilyJournal(map.path, map::SmallMap::config({"rotor.mass_kg=0.9"}).study, false),
               ConfigError);
}

TEST(FamilyJournal, KeepsASecondProcessAwayUntilItLeaves) {
  const map::SmallMap map;
  const sweep::Study study = map::SmallMap::config().study;
  FamilyJournal journal(map.path, study, false);
  EXPECT_THROW(FamilyJournal(map.path, study, false), LockedError);
}

}  // namespace
}  // namespace rubsweep::branch::journal
