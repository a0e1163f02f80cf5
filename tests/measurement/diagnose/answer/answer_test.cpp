#include "rubsweep/measurement/diagnose/answer/answer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "../inference/small_problem.hpp"
#include "small_answer.hpp"

namespace rubsweep::diagnose::answer {
namespace {

using inference::Diagnosis;
using inference::DiagnosisProblem;

/// The answer for a recording of one of the simulated cases.
Answer answer_to_case(std::size_t candidate, RecordingFacts facts = {}) {
  const DiagnosisProblem problem = inference::small_problem();
  std::size_t i = 0;
  while (inference::small_set().cases[i].candidate != candidate) ++i;
  response::spectrum::SpectrumWorkspace workspace;
  const features::DescribedMotion seen =
      inference::observe(problem, inference::small_set().cases[i], i, workspace).seen;
  inference::DiagnosisOptions options;
  const Diagnosis diagnosis = inference::diagnose(problem, seen, options, inference::small_set());
  const MotionLines recorded =
      up_to(inference::small_set().cases[i].motion.lines, inference::seen_order(problem.measuring));
  return answer_of(problem, diagnosis, seen, recorded, std::move(facts), {});
}

TEST(Answer, PutsTheLikeliestFirst) {
  const Answer answer = answer_to_case(1);
  EXPECT_EQ(answer.candidates[0].name, "one_side");
  double sum = answer.none;
  for (const CandidateAnswer& candidate : answer.candidates) sum += candidate.probability;
  EXPECT_NEAR(sum, 1, 1e-12);
  // This rotor has no places along a shaft, and this stop is a spring.
  EXPECT_EQ(answer.candidates[0].numbers.size(), inference::all_quantities.size() - 2);
  for (const NumberInterval& number : answer.candidates[0].numbers) {
    if (number.name == "stop_angle_deg") continue;
    EXPECT_LE(number.low_95, number.median) << number.name;
    EXPECT_LE(number.median, number.high_95) << number.name;
  }
  EXPECT_EQ(answer.deciding.size(), 5U);
}

TEST(Answer, LaysTheCaseItselfOverTheRecording) {
  const Answer answer = answer_to_case(1);
  ASSERT_FALSE(answer.best.empty());
  EXPECT_EQ(answer.best.front().candidate, "one_side");
  EXPECT_LT(answer.best.front().overlay.unexplained, 1e-3);
}

TEST(Answer, ComparesNoFeaturesWithACandidateWithoutCases) {
  const DiagnosisProblem problem = inference::small_problem();
  inference::CaseSet stops_alone = inference::small_set();
  std::erase_if(stops_alone.cases, [](const auto& one) { return one.candidate == 0; });
  inference::DiagnosisOptions options;
  const features::DescribedMotion seen = inference::recorded_case(1, 51);
  const Diagnosis diagnosis = inference::diagnose(problem, seen, options, stops_alone);
  const Answer answer =
      answer_of(problem, diagnosis, seen, stops_alone.cases.front().motion.lines, RecordingFacts{}, {});
  EXPECT_EQ(answer.candidates[0].name, "one_side");
  EXPECT_TRUE(answer.deciding.empty());
}

TEST(Answer, OfNoRubHasNoNumbersOfAStop) {
  const Answer answer = answer_to_case(0);
  EXPECT_EQ(answer.candidates[0].name, "no_rub");
  EXPECT_TRUE(answer.candidates[0].numbers.empty());
}

TEST(Answer, TrustsNoClippedProbe) {
  RecordingFacts facts;
  facts.findings = {"'x' is clipped 40 times"};
  const Answer answer = answer_to_case(1, facts);
  EXPECT_TRUE(answer.clipped);
  EXPECT_EQ(answer.none, 1);
  EXPECT_EQ(answer.candidates[0].probability, 0);
}

TEST(Answer, FindsScaleTurnAndMark) {
  const MotionLines recorded = small_motion();
  MotionLines simulated = recorded;
  for (int k = -simulated.last(); k <= simulated.last(); ++k)
    simulated.at(k) *= std::polar(7.0, 0.4 + k * 2 * 3.14159265358979324 * 11 / 64 / 4);
  const Overlay overlay = lay_over(recorded, simulated, true);
  EXPECT_LT(overlay.unexplained, 1e-12);
  EXPECT_LT((overlay.simulated.amplitude - recorded.amplitude).norm(), 1e-9);
}

TEST(Answer, LeavesWhatTheOtherMotionDoesNotHave) {
  MotionLines other = small_motion();
  other.at(2) = 0;
  // The energies are 1 and 1/4; a circle of the same size has |c|^2 / (1.25 x 1.25) in common, with |c| = 1.
  const double common = 1e-4 * std::sqrt(1.25) * 1e-4;
  const double left = 2 * 1.25e-8 - 2 * common;
  EXPECT_NEAR(lay_over(small_motion(), other, true).unexplained, left / 1.25e-8, 1e-9);
}

}  // namespace
}  // namespace rubsweep::diagnose::answer
