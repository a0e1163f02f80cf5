#include "rubsweep/measurement/diagnose/answer/answer_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "small_answer.hpp"

namespace rubsweep::diagnose::answer {
namespace {

TEST(AnswerTextAnswerTables, ListProbabilities) {
  EXPECT_EQ(probabilities_csv(small_answer()),
            "candidate,probability\none_side,0.9\nannular,0.06\nnone_of_these,0.04\n");
}

TEST(AnswerTextAnswerTables, LayTheMotionsSideBySide) {
  const std::string plane = orbits_csv(small_answer(), small_motion(), true),
                    probe = orbits_csv(small_answer(), small_motion(), false);
  EXPECT_TRUE(
      plane.starts_with("turns,x_m,y_m,simulated_x_m,simulated_y_m\n0.000000,0.0001,5e-05,0.0001,5e-05\n"))
      << plane;
  EXPECT_TRUE(probe.starts_with("turns,x_m,simulated_x_m\n0.000000,0.0001,0.0001\n")) << probe;
  EXPECT_EQ(std::ranges::count(plane, '\n'), 1 + 4 * 64);
}

TEST(AnswerTextAnswerTables, ListTheLinesThatAreThere) {
  EXPECT_EQ(compared_lines_csv(small_answer(), small_motion()),
            "order,recorded_m,simulated_m\n0.5,5e-05,5e-05\n1,0.0001,0.0001\n");
}

TEST(AnswerTextAnswerJson, SaysAllThatIsKnown) {
  const auto root = nlohmann::json::parse(answer_json(small_answer()));
  EXPECT_EQ(root["candidates"][0]["name"], "one_side");
  EXPECT_DOUBLE_EQ(root["candidates"][0]["probability"], 0.9);
  EXPECT_DOUBLE_EQ(root["candidates"][0]["numbers"]["clearance_m"]["high_95"], 3e-4);
  EXPECT_DOUBLE_EQ(root["none_of_these"]["p_value"], 0.37);
  EXPECT_EQ(root["simulations"]["interrupted"], false);
  EXPECT_EQ(root["deciding_features"][0]["name"], "energy at 1X");
  EXPECT_EQ(root["best_motions"][0]["candidate"], "one_side");
  EXPECT_DOUBLE_EQ(root["next_measurements"][0]["information_bits"], 0.4);
  EXPECT_DOUBLE_EQ(root["recording"]["speed_hz"], 70);
}

TEST(AnswerText, NamesOtherCausesWhereNoRubIsLikely) {
  Answer answer = small_answer();
  answer.signs = {{ForeignCause::oil_whirl, 0.93, 0.44}};
  const std::string sign =
      "  oil_whirl              93 % at 0.44X: a forward whirl at less than half the speed";
  EXPECT_EQ(answer_text(answer).find("oil_whirl"), std::string::npos);
  answer.candidates[0].probability = 0.3;
  EXPECT_NE(answer_text(answer).find(sign), std::string::npos) << answer_text(answer);
  answer.candidates[0].cause = Cause::no_rub;
  answer.candidates[0].probability = 0.9;
  EXPECT_NE(answer_text(answer).find(sign), std::string::npos);
  const auto root = nlohmann::json::parse(answer_json(answer));
  EXPECT_EQ(root["other_causes"][0]["cause"], "oil_whirl");
  EXPECT_DOUBLE_EQ(root["other_causes"][0]["share_off_1x"], 0.93);
}

std::string first_line(const Answer& answer) {
  const std::string text = answer_text(answer);
  return text.substr(0, text.find('\n'));
}

TEST(AnswerText, BeginsWithHowSureItIs) {
  EXPECT_EQ(first_line(small_answer()), "one_side, 90 % (sure): it rubs on one flat stop");
  Answer open = small_answer();
  open.candidates[0].probability = 0.45;
  EXPECT_EQ(first_line(open), "one_side, 45 % (not decided): it rubs on one flat stop");
}

TEST(AnswerText, SaysWhenItIsNoneOfThese) {
  Answer answer = small_answer();
  answer.none = 0.93;
  answer.candidates[0].probability = 0.05;
  EXPECT_EQ(first_line(answer), "none of these, 93 % (sure): no simulated motion resembles the recording");
  answer.size_fits = false;
  EXPECT_EQ(
      first_line(answer),
      "none of these, 93 % (sure): no simulated motion of these clearances and this unbalance is as large as "
      "the recording");
  answer.clipped = true;
  EXPECT_EQ(first_line(answer),
            "none of these can be told: a probe is clipped, and shows what no rotor does");
}

TEST(AnswerText, SaysNumbersWithTheirIntervals) {
  const std::string text = answer_text(small_answer());
  EXPECT_NE(text.find("clearance              200 um, 95 % from 150 um to 300 um"), std::string::npos)
      << text;
  EXPECT_NE(text.find("stop_angle             90 deg, 95 % from 80 deg to 101 deg"), std::string::npos)
      << text;
  EXPECT_NE(text.find("4200 rpm"), std::string::npos);
  EXPECT_NE(text.find("at 77 Hz (4620 rpm)            0.40 bits"), std::string::npos) << text;
  EXPECT_NE(answer_text(small_answer(), {.unit = model::LengthUnit::mil}).find("mil"), std::string::npos);
}

TEST(AnswerText, SaysWhereAStopMayStandInAnyDirection) {
  Answer answer = small_answer();
  answer.candidates[0].numbers.back() = {"stop_angle_deg", 10, -160, 162};
  EXPECT_NE(answer_text(answer).find("stop_angle             any direction\n"), std::string::npos);
  answer.candidates[0].numbers.back() = {"stop_angle_deg", -178, 164, -12};
  EXPECT_NE(answer_text(answer).find("from 164 deg to -12 deg"), std::string::npos);
}

TEST(AnswerText, SaysThatItWasInterrupted) {
  Answer answer = small_answer();
  answer.interrupted = true;
  answer.candidates[0].standard_error = 0.061;
  const std::string text = answer_text(answer);
  EXPECT_NE(text.find("interrupted"), std::string::npos);
  EXPECT_NE(text.find("one_side               90 % +- 7 %\n"), std::string::npos) << text;
}

TEST(AnswerText, SaysPlacesAlongTheShaftInMetres) {
  Answer answer = small_answer();
  answer.candidates[0].numbers.push_back({"position_m", 0.29, 0.2, 0.31});
  EXPECT_NE(answer_text(answer).find("position               0.29 m, 95 % from 0.2 m to 0.31 m"),
            std::string::npos);
}

TEST(AnswerText, HasWordsForEveryCause) {
  for (const Cause cause : all_causes) EXPECT_FALSE(words_for(cause).empty());
}

}  // namespace
}  // namespace rubsweep::diagnose::answer
