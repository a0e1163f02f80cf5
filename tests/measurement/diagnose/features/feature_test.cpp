#include "rubsweep/measurement/diagnose/features/feature.hpp"

#include <gtest/gtest.h>

namespace rubsweep::diagnose::features {
namespace {

TEST(Feature, IsAddedInOrder) {
  Features features;
  add(features, "one", 1);
  add(features, "two", 2);
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[1].name, "two");
  EXPECT_EQ(features[1].value, 2);
}

}  // namespace
}  // namespace rubsweep::diagnose::features
