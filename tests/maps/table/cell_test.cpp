#include "rubsweep/maps/table/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::table {
namespace {

constexpr NumberStyle point{',', false}, comma{';', true};

TEST(Cells, ArePartedAndFreedOfBlanksAndQuotes) {
  EXPECT_EQ(cells_of(" a ;\"b c\";;d\r", ';'), (std::vector<std::string_view>{"a", "b c", "", "d"}));
}

TEST(Cells, ArePartedByBlanksButForThoseOfAUnit) {
  using Cells = std::vector<std::string_view>;
  EXPECT_EQ(cells_of("  1.0   -2e3\t3 \r", ' '), (Cells{"1.0", "-2e3", "3"}));
  EXPECT_EQ(cells_of("Speed [rpm]  Kxx [N / m] \"K yy\"(N)", ' '),
            (Cells{"Speed [rpm]", "Kxx [N / m]", "\"K yy\"(N)"}));
  EXPECT_EQ(cells_of("(rpm) (N/m)", ' '), (Cells{"(rpm)", "(N/m)"}));
  EXPECT_EQ(cells_of("a (open", ' '), (Cells{"a (open"}));
  EXPECT_EQ(cells_of(" ", ' '), (Cells{""}));
}

TEST(CellNumberIn, ReadsExponentsOfFortran) {
  EXPECT_EQ(number_in("1.5D+03", point), 1500);
  EXPECT_EQ(number_in("-1,5d-03", comma), -1.5e-3);
  for (const char* wrong : {"1D3", "D+3", "1.0D+", "1.0D+1D+1"})
    EXPECT_FALSE(number_in(wrong, point)) << wrong;
}

TEST(CellNumberIn, ReadsPointsAndCommas) {
  EXPECT_EQ(number_in("-1.5e-3", point), -1.5e-3);
  EXPECT_EQ(number_in("+2", point), 2);
  EXPECT_EQ(number_in("-1,5e-3", comma), -1.5e-3);
  EXPECT_TRUE(std::isnan(number_in("", point).value()));
  EXPECT_TRUE(std::isnan(number_in("NaN", comma).value()));
  for (const char* wrong : {"1,5", "x", "1 2", "0x10", "inf", "1e999", "+"})
    EXPECT_FALSE(number_in(wrong, point)) << wrong;
  for (const char* wrong : {"1.5", "1.234,5", "1,2,3"}) EXPECT_FALSE(number_in(wrong, comma)) << wrong;
}

TEST(Cell, PartsNameAndUnit) {
  EXPECT_EQ(heading_of("Speed [rpm]").name, "Speed");
  EXPECT_EQ(heading_of("Speed [rpm]").unit, "rpm");
  EXPECT_EQ(heading_of("X (probe 2) (um)").name, "X (probe 2)");
  EXPECT_EQ(heading_of("t_s").unit, "");
  EXPECT_EQ(heading_of("odd)").name, "odd)");
}

TEST(Cell, UnitsAreOneInAnyWriting) {
  for (const char* written : {"N-s/m", "N s/m", "Ns/m", "N*s/m", "N.s/m", "N\u00b7s/m"})
    EXPECT_EQ(plain_unit(written), "Ns/m") << written;
  EXPECT_EQ(plain_unit("N/\u00b5m"), "N/um");
  EXPECT_EQ(plain_unit("N/\u03bcm"), "N/um");
}

TEST(Cell, KnowsUnits) {
  for (const char* unit :
       {"s", "ms", "\u00b5m", "Volts", "V", "lbf-s/in", "N/m", "RPM", "[anything]", "(m/s)", "-"})
    EXPECT_TRUE(is_unit(unit)) << unit;
  for (const char* name : {"X", "KP", "Time", "kxx", "", "()", "Rate=1000Hz"})
    EXPECT_FALSE(is_unit(name)) << name;
}

}  // namespace
}  // namespace rubsweep::table
