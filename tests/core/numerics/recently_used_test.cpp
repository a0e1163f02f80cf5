#include "rubsweep/core/numerics/recently_used.hpp"

#include <gtest/gtest.h>

namespace rubsweep::numerics {
namespace {

bool finds(RecentlyUsed<int>& recent, int number) {
  return recent.find([number](const int& one) { return one == number; }) != nullptr;
}

TEST(RecentlyUsed, TheOneThatWasUsedLongestAgoIsDropped) {
  RecentlyUsed<int> recent(2);
  EXPECT_FALSE(finds(recent, 1));
  recent.emplace(1);
  recent.emplace(2);
  ASSERT_TRUE(finds(recent, 1));  // used more recently than 2
  recent.emplace(3);
  recent.trim();
  EXPECT_FALSE(finds(recent, 2));
  EXPECT_TRUE(finds(recent, 1));
  EXPECT_TRUE(finds(recent, 3));
}

TEST(RecentlyUsed, WhatItHoldsStaysWhereItIs) {
  RecentlyUsed<int> recent(2);
  const int* first = &recent.emplace(1);
  recent.emplace(2);
  EXPECT_EQ(recent.find([](const int& one) { return one == 1; }), first);
  EXPECT_EQ(recent.newest(), first);
}

TEST(RecentlyUsed, SizesAreThoseThatItIsTold) {
  RecentlyUsed<int> recent(10);
  for (const int size : {3, 4, 5}) recent.emplace(size);
  const auto size = [](const int& one) { return static_cast<std::size_t>(one); };
  recent.trim(size);
  EXPECT_EQ(recent.size(), 2u);  // 5 + 4
  recent.emplace(20);
  recent.trim(size);
  EXPECT_EQ(recent.size(), 1u) << "the one used last stays whatever its size";
  EXPECT_TRUE(finds(recent, 20));
}

}  // namespace
}  // namespace rubsweep::numerics
