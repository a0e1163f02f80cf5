#include "rubreport/page.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "apps/rubreport/decoded.hpp"

namespace rubsweep::page {
namespace {

/// Record i, of `width` bytes, in data that were stored byte plane by byte plane.
std::uint64_t record(const std::string& planes, std::size_t width, std::size_t i) {
  std::uint64_t value = 0;
  for (std::size_t plane = 0; plane < width; ++plane)
    value |= std::uint64_t{static_cast<unsigned char>(planes[plane * (planes.size() / width) + i])}
             << (8 * plane);
  return value;
}

TEST(Page, NumbersComeBackToTheLastBit) {
  const std::vector<double> numbers{0.1,  -1e-300, 5e-324, std::numeric_limits<double>::infinity(),
                                    1e17, -0.0,    1320,   std::numeric_limits<double>::quiet_NaN()};
  const EncodedColumn encoded = encode_column({"speed_hz", numbers, {}});
  EXPECT_TRUE(encoded.words.empty());
  const std::string planes = decompressed(encoded.data);
  ASSERT_EQ(planes.size(), 8 * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(record(planes, 8, i), std::bit_cast<std::uint64_t>(numbers[i])) << i;
}

TEST(Page, WordsAreNumberedInTheOrderOfTheirRows) {
  const EncodedColumn encoded = encode_column({"class", {}, {"b", "", "b", "a", ""}});
  EXPECT_EQ(encoded.words, (std::vector<std::string>{"b", "", "a"}));
  const std::string planes = decompressed(encoded.data);
  ASSERT_EQ(planes.size(), 20u);
  for (const auto& [row, place] : {std::pair{0u, 0u}, {1u, 1u}, {2u, 0u}, {3u, 2u}, {4u, 1u}})
    EXPECT_EQ(record(planes, 4, row), place);
}

}  // namespace
}  // namespace rubsweep::page
