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
  // A motion at rest, or one that repeats after whole turns, has the same measures at all times.
  for (const MotionClass motion_class : motion_classes) {
    const bool expected =
        motion_class == MotionClass::non_contact || motion_class == MotionClass::synchronous ||
        motion_class == MotionClass::resting_contact || motion_class == MotionClass::subharmonic;
    EXPECT_EQ(row_of(motion_class).repeats, expected) << to_string(motion_class);
  }
}

using spectrum::OrbitKind;
using spectrum::WhirlKind;

TEST(MotionClassKind, EveryClassHasARowWhateverItsMeasures) {
  for (const MotionClass motion_class : motion_classes) {
    const MotionKind& kind = kind_of(motion_class, {}, {}, {}, false);
    EXPECT_TRUE(kind.name.starts_with(to_string(motion_class))) << kind.name;
    EXPECT_EQ(motion_kind_of(kind.name), &kind);
    if (motion_class != MotionClass::unsettled) {
      EXPECT_EQ(kind.settled_rub, row_of(motion_class).rubs) << kind.name;
    }
  }
  EXPECT_EQ(motion_kind_of("rolling"), nullptr);
}

TEST(MotionClassKind, SubharmonicMotionsOfLongPeriodsAreOne) {
  const auto name = [](int order) { return kind_of(MotionClass::subharmonic, order, {}, {}, false).name; };
  EXPECT_EQ(name(2), "subharmonic_2");
  EXPECT_EQ(name(7), "subharmonic_7");
  EXPECT_EQ(name(8), "subharmonic_8");
  EXPECT_EQ(name(13), "subharmonic_8");
}

TEST(MotionClassKind, ShapeAndDirectionPartTheMotionsAtAnAnnularStop) {
  const auto circle = [](WhirlKind whirl) {
    return kind_of(MotionClass::synchronous, 1, OrbitKind::circle, whirl, false).name;
  };
  EXPECT_EQ(circle(WhirlKind::forward), "synchronous_circle");
  EXPECT_EQ(circle(WhirlKind::mixed), "synchronous_circle");
  EXPECT_EQ(circle(WhirlKind::backward), "synchronous_circle_backward");
  EXPECT_EQ(kind_of(MotionClass::synchronous, 1, OrbitKind::oval, WhirlKind::backward, false).name,
            "synchronous");
  const auto closed = [](WhirlKind whirl, bool comb) {
    return kind_of(MotionClass::quasi_periodic, {}, OrbitKind::oval, whirl, comb).name;
  };
  EXPECT_EQ(closed(WhirlKind::forward, true), "quasi_periodic_oval");
  EXPECT_EQ(closed(WhirlKind::backward, true), "quasi_periodic_whip");
  EXPECT_EQ(closed(WhirlKind::backward, false), "quasi_periodic");
}

TEST(MotionClassKind, NamesLabelsAndColoursAreUnique) {
  std::set<std::string_view> names, labels;
  std::set<std::uint32_t> colours, dark;
  for (const MotionKind& kind : motion_kinds) {
    names.insert(kind.name);
    labels.insert(kind.label);
    colours.insert(kind.colour);
    dark.insert(kind.dark_colour);
  }
  for (const std::size_t size : {names.size(), labels.size(), colours.size(), dark.size()})
    EXPECT_EQ(size, motion_kinds.size());
}

}  // namespace

}  // namespace rubsweep::response::motion
