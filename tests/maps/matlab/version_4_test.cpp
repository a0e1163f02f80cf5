#include "rubsweep/maps/matlab/version_4.hpp"

#include <bit>

#include "maps/matlab/matio_file.hpp"

namespace rubsweep::matlab {
namespace {

/// A number as a machine with the large end first wrote it.
template <class Number>
std::string large_end_first(Number number) {
  std::string raw(reinterpret_cast<const char*>(&number), sizeof number);
  std::ranges::reverse(raw);
  return raw;
}

std::string head(std::int32_t type, std::int32_t rows, std::int32_t columns) {
  return large_end_first(type) + large_end_first(rows) + large_end_first(columns) + large_end_first(0) +
         large_end_first(2) + std::string("K\0", 2);
}

TEST(Version4, OfTheOtherOrderOfBytes) {
  const std::string bytes = head(1000, 1, 2) + large_end_first(0.5) + large_end_first(-3.0);
  ASSERT_TRUE(is_version_4(bytes));
  EXPECT_EQ(find(read_all(bytes), "K").values, (std::vector<double>{0.5, -3}));
  EXPECT_EQ(
      find(read_all(head(1030, 2, 1) + large_end_first(std::int16_t{-2}) + large_end_first(std::int16_t{9})),
           "K")
          .values,
      (std::vector<double>{-2, 9}));
}

TEST(Version4, SparseMatricesAreTriples) {
  std::string bytes = head(1002, 3, 3);
  for (const double value : {1.0, 2.0, 2.0, 1.0, 2.0, 2.0, 4.0, 5.0, 0.0}) bytes += large_end_first(value);
  const auto read = read_all(bytes);
  EXPECT_EQ(find(read, "K").dims, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(find(read, "K").values, (std::vector<double>{4, 0, 0, 5}));
  std::string outside = head(1002, 2, 3);
  for (const double value : {7.0, 2.0, 1.0, 2.0, 4.0, 0.0}) outside += large_end_first(value);
  EXPECT_EQ(fault(outside), "is damaged: a sparse matrix whose places are none");
}

TEST(Version4, SizesThatAreNoneAreRefused) {
  EXPECT_EQ(fault(head(1000, -1, 2)), "is damaged: a size below 0");
  EXPECT_EQ(fault(head(1000, 2000000000, 2000000000)), "holds more than 67108864 numbers in 'K'");
  EXPECT_EQ(fault(head(1000, 3, 3) + large_end_first(1.0)), "breaks off");
  EXPECT_FALSE(is_version_4("t_s,x_m,y_m,keyphasor_v\n"));
}

}  // namespace
}  // namespace rubsweep::matlab
