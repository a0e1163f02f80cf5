#include "rubsweep/motion_kinds_csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rubsweep/core/response/motion/motion_class.hpp"

namespace rubsweep::apps {
namespace {

TEST(MotionKindsCsv, HasARowForEveryKind) {
  const std::string text = motion_kinds_csv();
  EXPECT_TRUE(
      text.starts_with("name,label,colour,dark_colour,sign,hatched,settled_rub\n"
                       "non_contact,no contact,#F4F4F4,#2B2F36,.,0,0\n"));
  EXPECT_NE(text.find("\nfailed,failed,#CC0000,#CC0000,!,1,0\n"), std::string::npos);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, '\n')),
            response::motion::motion_kinds.size() + 1);
}

}  // namespace
}  // namespace rubsweep::apps
