#include "rubsweep/analysis/page/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rubsweep::page {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Two speeds by two whirl ratios: at rest, two motions with contact, and a chaotic one.
MapTable four_cells() {
  return {"1",
          "d",
          4,
          {{"speed_hz", {50, 80, 50, 80}, {}},
           {"whirl_ratio", {0.2, 0.2, 0.6, 0.6}, {}},
           {"class", {}, {"non_contact", "subharmonic", "subharmonic", "chaotic"}},
           {"order", {none, 2, 2, none}, {}},
           {"proof", {}, {"rest", "floquet", "floquet", "observed"}},
           {"robust", {}, {"yes", "yes", "no", "no"}},
           {"contact_fraction", {0, 0.1, 0.2, 0.3}, {}},
           {"peak_contact_force_n", {0, 100, 400, 300}, {}},
           {"peak_displacement_m", {1e-4, 2e-3, 3e-3, 4e-3}, {}}}};
}

const sweep::Grid grid{{50, 80}, sweep::UnbalanceMeasure::whirl_ratio, {0.2, 0.6}};

bool says(const std::vector<std::string>& sentences, const std::string& sentence) {
  return std::find(sentences.begin(), sentences.end(), sentence) != sentences.end();
}

TEST(Findings, SayWhatTheMapHolds) {
  const auto said = findings(four_cells(), grid);
  for (const char* sentence :
       {"4 cells: 2 speeds from 50 to 80 Hz (3000 to 4800 rpm), 2 whirl ratios from 0.2 to 0.6.",
        "Rub lasts in 3 cells (75.0 %), from 50 to 80 Hz (3000 to 4800 rpm); the smallest unbalance with it "
        "is whirl ratio "
        "0.2, "
        "at 80 Hz (4800 rpm).",
        "The most frequent rub is subharmonic 1/2: 2 cells (50.0 %), from 50 to 80 Hz (3000 to 4800 rpm).",
        "The largest contact force is 400 N, at 50 Hz (3000 rpm) and whirl ratio 0.6 (subharmonic 1/2).",
        "The largest displacement is 4 mm, at 80 Hz (4800 rpm) and whirl ratio 0.6 (chaotic).",
        "Chaos, by a positive Lyapunov exponent, is found in 1 cell (25.0 %).",
        "A kick that differs by a millionth leads to another class in 2 cells (50.0 %)."}) {
    EXPECT_TRUE(says(said, sentence)) << sentence << "\n" << testing::PrintToString(said);
  }
}

TEST(Findings, AQuietMapSaysSo) {
  MapTable map = four_cells();
  for (auto& column : map.columns) {
    if (column.name == "class") column.words.assign(4, "non_contact");
    if (column.name == "contact_fraction") column.numbers.assign(4, 0);
  }
  EXPECT_TRUE(says(findings(map, grid), "Rub lasts in no cell."));
}

}  // namespace
}  // namespace rubsweep::page
