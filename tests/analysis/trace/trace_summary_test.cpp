#include "rubsweep/analysis/trace/trace_summary.hpp"

#include <gtest/gtest.h>

namespace rubsweep::trace {
namespace {

/// 4 turns of 4 samples: lines at -2X to 1.75X. `amplitude` by line.
response::spectrum::FullSpectrum spectrum_of(std::initializer_list<std::pair<int, double>> amplitude) {
  response::spectrum::FullSpectrum spectrum{
      .turns = 4, .samples_per_revolution = 4, .amplitude_m = std::vector<double>(16)};
  for (const auto& [k, value] : amplitude) spectrum.amplitude_m[static_cast<std::size_t>(k + 8)] = value;
  return spectrum;
}

TEST(TraceSummaryLargestLines, AreSortedPeaksWithoutTheMean) {
  const auto lines = largest_lines(
      spectrum_of({{-8, 1e-5}, {-4, 3e-4}, {0, 5e-3}, {2, 7e-4}, {3, 6.9e-4}, {7, 1e-4}}), 3, 1e-3);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].order, 0.5);
  EXPECT_EQ(lines[0].amplitude_m, 7e-4);
  EXPECT_EQ(lines[1].order, -1);
  EXPECT_EQ(lines[2].order, 1.75);
}

TEST(TraceSummaryLargestLines, StopAtTheFloorOfSignificance) {
  EXPECT_EQ(largest_lines(spectrum_of({{4, 1e-3}, {-4, 0.9e-6}}), 5, 1e-6).size(),
            1u);  // 1e-3 of the largest
  EXPECT_EQ(largest_lines(spectrum_of({{4, 1e-3}, {-4, 1.1e-6}}), 5, 1e-6).size(), 2u);
  EXPECT_EQ(largest_lines(spectrum_of({{4, 0.9e-9}}), 5, 1e-3).size(), 0u);  // 1e-6 of the clearance
  EXPECT_EQ(largest_lines(spectrum_of({}), 5, 1e-3).size(), 0u);
  EXPECT_EQ(largest_lines({}, 5, 1e-3).size(), 0u);
}

TEST(TraceSummary, ShowsPeaksHitsLinesAndEffort) {
  Trace trace;
  trace.revolutions = 10;
  trace.turns.assign(
      10, {.hits = 1, .contact_fraction = 0.2, .peak_displacement_m = 2e-3, .peak_contact_force_n = 50});
  trace.turns[0].peak_displacement_m = 3.5e-3;
  trace.turns[0].peak_contact_force_n = 400;
  trace.last_contact_revolution = 9;
  trace.effort = {.rhs_calls = 7000, .steps = 1000, .refused = 25, .switches = 40};
  TraceWindow window;
  window.turns = 4;
  window.contact = facts_of_last(trace, 4);
  window.contact.hits = 2;
  window.spectrum = spectrum_of({{2, 7e-4}, {-4, 3e-4}});
  EXPECT_EQ(
      trace_summary(trace, window, 1e-3),
      "run       10 revolutions, last contact in revolution 9\n"
      "peak      3.5 clearances, 400 N; 2 clearances, 50 N in the last 4 revolutions\n"
      "contact   0.5 hits per revolution, 20 % of the time, in the last 4 revolutions\n"
      "lines     +0.5X 0.0007 m, -1X 0.0003 m\n"
      "effort    700.0 right-hand sides, 100.0 steps, 2.5 refused, 4.00 mode switches per revolution\n");
}

TEST(TraceSummary, SaysLengthsAsTheyAreAskedFor) {
  Trace trace;
  trace.revolutions = 4;
  trace.turns.assign(4, {.peak_displacement_m = 2e-3, .peak_contact_force_n = 50});
  TraceWindow window;
  window.turns = 4;
  window.contact = facts_of_last(trace, 4);
  window.spectrum = spectrum_of({{2, 7e-4}});
  const std::string text = trace_summary(trace, window, 1e-3, {model::LengthUnit::um, true});
  EXPECT_NE(text.find("peak      2 clearances, 2000 um, 50 N; "), std::string::npos) << text;
  EXPECT_NE(text.find("lines     +0.5X 1400 um peak to peak\n"), std::string::npos) << text;
}

TEST(TraceSummary, OfARunWithoutARevolutionSaysSo) {
  EXPECT_EQ(trace_summary({}, {}, 1e-3), "run       0 revolutions, no contact\n");
}

}  // namespace
}  // namespace rubsweep::trace
