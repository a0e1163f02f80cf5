#include "rubsweep/response/proof/foretold.hpp"

#include <gtest/gtest.h>

namespace rubsweep::response::proof {
namespace {

TEST(Foretold, AsksForReturnsInARowAndForHalfTheDistance) {
  Foretold foretold(3);
  foretold.add(0, 1, 0.9);
  foretold.add(0.009, 1, 0.9);
  EXPECT_FALSE(foretold.holds(0.1, 1));
  foretold.add(0.011, 1, 0.9);  // more than a tenth of the tenth that a return gains
  foretold.add(0, 1, 0.9);
  foretold.add(0, 1, 0.9);
  EXPECT_FALSE(foretold.holds(0.1, 1));
  foretold.add(0, 1, 0.9);
  EXPECT_TRUE(foretold.holds(0.49, 1));
  EXPECT_FALSE(foretold.holds(0.51, 1));
}

}  // namespace
}  // namespace rubsweep::response::proof
