#include "rubsweep/measurement/diagnose/answer/answer_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "small_answer.hpp"

namespace rubsweep::diagnose::answer {
namespace {

TEST(AnswerJson, SaysAllThatIsKnown) {
  const auto root = nlohmann::json::parse(answer_json(small_answer()));
  EXPECT_EQ(root["candidates"][0]["name"], "one_side");
  EXPECT_DOUBLE_EQ(root["candidates"][0]["probability"], 0.9);
  EXPECT_DOUBLE_EQ(root["candidates"][0]["numbers"]["clearance_m"]["high_95"], 3e-4);
  EXPECT_DOUBLE_EQ(root["none_of_these"]["p_value"], 0.37);
  EXPECT_EQ(root["simulations"]["stands_still"], true);
  EXPECT_EQ(root["deciding_features"][0]["name"], "energy at 1X");
  EXPECT_EQ(root["best_motions"][0]["candidate"], "one_side");
  EXPECT_DOUBLE_EQ(root["next_measurements"][0]["information_bits"], 0.4);
  EXPECT_DOUBLE_EQ(root["recording"]["speed_hz"], 70);
}

}  // namespace
}  // namespace rubsweep::diagnose::answer
