#include "rubsweep/core/response/motion/motion_class.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace rubsweep::response::motion {
namespace {

TEST(MotionClasses, AreAllInTheTableWithAWordAndADescriptionOfTheirOwn) {
  EXPECT_EQ(motion_classes.front(), MotionClass::non_contact);
  EXPECT_NE(std::ranges::find(motion_classes, MotionClass::failed), motion_classes.end());
  std::set<std::string_view> words, descriptions;
  for (const MotionClass motion_class : motion_classes) {
    const MotionClassRow row = row_of(motion_class);
    EXPECT_EQ(to_string(motion_class), row.word);
    EXPECT_TRUE(words.insert(row.word).second) << row.word;
    EXPECT_TRUE(descriptions.insert(row.description).second) << row.word;
  }
  EXPECT_EQ(to_string(static_cast<MotionClass>(motion_classes.size())), "");
}

TEST(MotionClasses, WhatRubsAndWhatRepeats) {
  EXPECT_FALSE(row_of(MotionClass::non_contact).rubs);
  EXPECT_TRUE(row_of(MotionClass::subharmonic).rubs);
  EXPECT_FALSE(row_of(MotionClass::failed).rubs);
  // A motion at rest, or that returns after whole turns, measures the same whenever one looks.
  for (const MotionClass motion_class : motion_classes) {
    const bool expected =
        motion_class == MotionClass::non_contact || motion_class == MotionClass::synchronous ||
        motion_class == MotionClass::resting_contact || motion_class == MotionClass::subharmonic;
    EXPECT_EQ(row_of(motion_class).repeats, expected) << to_string(motion_class);
  }
}

}  // namespace
}  // namespace rubsweep::response::motion
