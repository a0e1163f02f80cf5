#include "rubsweep/maps/batch/captions.hpp"

#include <gtest/gtest.h>

namespace rubsweep::batch {
namespace {

TEST(CaptionsCaptionLines, AreCommentsHoweverManyLinesANoteHas) {
  EXPECT_EQ(caption_lines({"T", "A", "one\n\nspeed_hz,class\n"}),
            "# title T\n# author A\n# note one\n# note\n# note speed_hz,class\n");
  EXPECT_EQ(caption_lines({}), "");
}

}  // namespace
}  // namespace rubsweep::batch
