#include "rubsweep/maps/config/machine/table_file.hpp"

#include <gtest/gtest.h>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::config::machine {
namespace {

std::string written(const yaml::Node& table) {
  std::string text;
  for (std::size_t i = 0; i < table.keys.size(); ++i) {
    text += table.keys[i].text + ':';
    for (const yaml::Node& cell : table.items[i].items) text += ' ' + cell.text;
    text += '\n';
  }
  return text;
}

constexpr const char* two_speeds =
    "         1    500.00\n"
    "  1.0000000E+05  2.0000000E+03 -2.0000000E+03  1.5000000E+05\n"
    "  1.0000000D+02  0.0000000E+00  0.0000000E+00  2.0000000E+02\n"
    "         2   1000.00\r\n"
    "  2.0000000E+05  3.0000000E+03 -3.0000000E+03  2.5000000E+05\n"
    "  5.0000000E+01  1.0000000E+00 -1.0000000E+00  6.0000000E+01\n\n";

std::string with_units(const char* flags) {
  return std::string("Pump 7\nDE\nof 3 titles\n") + flags + two_speeds;
}

std::string fault_of(const std::string& text) {
  try {
    return read_ansys_bearing(text, 0) ? "read" : "no such file";
  } catch (const table::Fault& fault) {
    return std::to_string(fault.line) + ':' + std::to_string(fault.column) + ": " + fault.wrong +
           ", allowed: " + fault.allowed;
  }
}

TEST(TableFileAnsysBearing, IsReadInTheUnitsOfItsFlags) {
  const auto in_si = read_ansys_bearing(with_units("         2         0         0\n"), 3);
  ASSERT_TRUE(in_si);
  EXPECT_EQ(written(*in_si),
            "speed_rad_per_s: 500 1000\n"
            "kxx_n_per_m: 100000 200000\nkxy_n_per_m: 2000 3000\nkyx_n_per_m: -2000 -3000\nkyy_n_per_m: "
            "150000 250000\n"
            "cxx_ns_per_m: 100 50\ncxy_ns_per_m: 0 1\ncyx_ns_per_m: 0 -1\ncyy_ns_per_m: 200 60\n");
  EXPECT_EQ(in_si->items[1].items[1].place.line, 9);
  EXPECT_EQ(in_si->items[1].items[1].place.column, 3);
  EXPECT_EQ(in_si->items[1].items[1].place.file, 3);
  EXPECT_EQ(written(*read_ansys_bearing(with_units(" 2 1 0\n"), 0)).substr(0, 48),
            "speed_rad_per_s: 500 1000\nkxx_lbf_per_in: 100000");
  EXPECT_EQ(written(*read_ansys_bearing(with_units(" 2 0\n"), 0)).substr(0, 33),
            "speed_rpm: 500 1000\nkxx_n_per_m: ");
  const std::string by_default = written(*read_ansys_bearing(with_units(" 2\n"), 0));
  EXPECT_EQ(by_default.substr(0, 20), "speed_rpm: 500 1000\n");
  EXPECT_NE(by_default.find("cyy_lbf_s_per_in: 200 60\n"), std::string::npos) << by_default;
}

TEST(TableFileAnsysBearing, TitlesMayBeLeftOut) {
  EXPECT_EQ(fault_of(std::string("2 0 0\n") + two_speeds), "read");
  EXPECT_EQ(fault_of(std::string("Bearing DE\n2 0 0\n") + two_speeds), "read");
}

TEST(TableFileAnsysBearing, OneThatIsNotWholeIsRefused) {
  EXPECT_EQ(fault_of(with_units(" 3 0 0\n")),
            "4:1: counts 3 speeds, and 6 lines follow, allowed: three lines for each speed");
  EXPECT_EQ(fault_of(with_units(" 2 0 2\n")), "4:1: '2' is no flag of units, allowed: 0 or 1");
  std::string text = with_units(" 2 0 0\n");
  text.replace(text.find("2.5000000E+05"), 13, "");
  EXPECT_EQ(fault_of(text), "9:1: is no line of a bearing of ANSYS, allowed: 4 numbers");
}

TEST(TableFileAnsysBearing, AnotherTextIsNone) {
  EXPECT_EQ(fault_of("speed_rpm kxx kxy kyx kyy\n1 2 3 4 5\n2 2 3 4 5\n"), "no such file");
  EXPECT_EQ(fault_of(""), "no such file");
  EXPECT_EQ(fault_of("1\n2 3\n1 2 3\n"), "no such file");
}

}  // namespace
}  // namespace rubsweep::config::machine
