#include "rubsweep/character_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::apps {
namespace {

using response::motion::MotionClass;

std::string line(MotionClass motion_class, std::optional<int> order = {}) {
  sweep::Row row;
  row.motion_class = motion_class;
  row.order = order;
  return report::map_line(row);
}

const sweep::Grid small_grid{{50, 60, 70}, sweep::UnbalanceMeasure::whirl_ratio, {0.2, 0.6}};

CharacterMap small_map() {
  CharacterMap map(small_grid);
  map.add(line(MotionClass::non_contact));
  map.add(line(MotionClass::chaotic));
  map.add(line(MotionClass::unsettled));
  map.add(line(MotionClass::subharmonic, 2));
  map.add(line(MotionClass::subharmonic, 12));
  map.add(line(MotionClass::subharmonic, 2));
  return map;
}

TEST(CharacterMap, HasACharacterForEachCellUnbalanceUpward) {
  EXPECT_EQ(small_map().text(80, false),
            "           0.6 2+2\n"
            "           0.2 .*?\n"
            "   whirl_ratio 50 Hz (3000 rpm) 70 Hz (4200 rpm)\n"
            "  * chaotic  + subharmonic of more than 9 turns  . non_contact\n"
            "  2 subharmonic 1/2  ? unsettled\n");
}

TEST(CharacterMap, LeavesUnfinishedCellsBlankAndOutOfTheLegend) {
  CharacterMap map(small_grid);
  for (int i = 0; i < 2; ++i) {
    map.add(line(MotionClass::chaotic));
    map.add_unfinished();
    map.add(line(MotionClass::chaotic));
  }
  EXPECT_EQ(map.text(80, false),
            "           0.6 * *\n"
            "           0.2 * *\n"
            "   whirl_ratio 50 Hz (3000 rpm) 70 Hz (4200 rpm)\n"
            "  * chaotic\n");
  EXPECT_NE(map.text(80, true).find("m*\x1b[0m \x1b["), std::string::npos);
  ASSERT_TRUE(map.typical_rub());
  EXPECT_EQ(map.name(*map.typical_rub()), "chaotic");
}

TEST(CharacterMap, IsInTheUnitsOfThePerson) {
  sweep::Grid written = small_grid;
  written.measure = sweep::UnbalanceMeasure::eccentricity_m;
  written.written_speed = {.key = "speed_rpm", .unit = "rpm", .units_per_si = 60};
  written.written_unbalance = {.key = "unbalance_g_mm",
                               .unit = "g mm",
                               .units_per_si = 1000,
                               .spacing = batch::Spacing{200, 600, 2, true}};
  CharacterMap map(written);
  for (int i = 0; i < 6; ++i) map.add(line(MotionClass::chaotic));
  EXPECT_EQ(map.text(80, false),
            "           600 ***\n"
            "           200 ***\n"
            "unbalance g mm 3000 rpm 4200 rpm\n"
            "               logarithmic: unbalance\n"
            "  * chaotic\n");
}

TEST(CharacterMap, ColoursChangeNoCharacter) {
  std::string text = small_map().text(80, true);
  EXPECT_NE(text.find("\x1b[48;2;204;102;119m"), std::string::npos);
  for (std::size_t begin = 0; (begin = text.find('\x1b')) != std::string::npos;)
    text.erase(begin, text.find('m', begin) - begin + 1);
  EXPECT_EQ(text, small_map().text(80, false));
}

TEST(CharacterMap, TheTypicalRubIsOfTheMostFrequentSettledKind) {
  const CharacterMap map = small_map();
  ASSERT_TRUE(map.typical_rub());
  EXPECT_EQ(map.name(*map.typical_rub()), "subharmonic 1/2");
  CharacterMap quiet(small_grid);
  for (int i = 0; i < 6; ++i) quiet.add(line(i < 5 ? MotionClass::unsettled : MotionClass::non_contact));
  EXPECT_FALSE(quiet.typical_rub());
}

TEST(CharacterMap, TheTypicalRubLiesInTheMiddle) {
  sweep::Grid row{{}, sweep::UnbalanceMeasure::eccentricity_m, {1e-4}};
  for (int i = 0; i < 9; ++i) row.speed_hz.push_back(50 + i);
  CharacterMap map(row);
  for (int i = 0; i < 9; ++i) map.add(line(i < 2 ? MotionClass::non_contact : MotionClass::chaotic));
  EXPECT_EQ(map.typical_rub(), 5u);
}

TEST(CharacterMap, ALargeMapIsThinnedToTheRoomThereIs) {
  sweep::Grid large{{}, sweep::UnbalanceMeasure::whirl_ratio, {}};
  for (int i = 0; i < 300; ++i) large.speed_hz.push_back(50 + i);
  for (int i = 0; i < 50; ++i) large.unbalance.push_back(0.01 * i);
  CharacterMap map(large);
  for (int i = 0; i < 300 * 50; ++i)
    map.add(line(i % 300 < 150 ? MotionClass::non_contact : MotionClass::chaotic));
  const std::string text = map.text(60, false);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 22);
  const std::string first = text.substr(0, text.find('\n'));
  EXPECT_EQ(first.size(), 60u);
  EXPECT_EQ(std::count(first.begin(), first.end(), '*'), 23);
}

TEST(CharacterMap, OfAnotherNumberOfCellsShowsNothing) {
  CharacterMap map(small_grid);
  map.add(line(MotionClass::chaotic));
  EXPECT_EQ(map.text(80, false), "");
}

}  // namespace
}  // namespace rubsweep::apps
