#include "rubsweep/branch/recent.hpp"

#include <gtest/gtest.h>

namespace rubsweep::branch {
namespace {

TEST(Recent, TheOneThatWasUsedLongestAgoIsForgotten) {
  Recent<int> recent(2);
  const auto find = [&](int number) {
    return recent.find([number](const int& one) { return one == number; });
  };
  EXPECT_EQ(find(1), nullptr);
  recent.keep(std::make_unique<int>(1));
  const int* second = recent.keep(std::make_unique<int>(2));
  ASSERT_TRUE(find(1));  // used later than 2 now
  EXPECT_EQ(find(2), second);
  ASSERT_TRUE(find(1));
  recent.keep(std::make_unique<int>(3));
  EXPECT_EQ(find(2), nullptr);
  EXPECT_TRUE(find(1));
  EXPECT_TRUE(find(3));
}

}  // namespace
}  // namespace rubsweep::branch
