#include "rubsweep/maps/matlab/read_file.hpp"

#include <bit>

#include "maps/batch/temporary_directory.hpp"
#include "maps/matlab/matio_file.hpp"

namespace rubsweep::matlab {
namespace {

struct Form {
  mat_ft version;
  matio_compression compression;
};

class ReadFile : public testing::TestWithParam<Form> {};

TEST_P(ReadFile, NumbersOfAllKindsAreThoseThatAnotherLibraryWrote) {
  const TemporaryDirectory directory;
  MatioFile file(directory.path() / "a.mat", GetParam().version, GetParam().compression);
  const bool old = GetParam().version == MAT_FT_MAT4;
  file.doubles("matrix", 2, 3, {1, 2, 3, 4, 1e300, -0.1});
  file.doubles("x", 1, 1, {7});
  file.phasor("phasor");
  file.text("note");
  if (!old) {
    file.write(MatioFile::variable<float>("short_ones", MAT_C_SINGLE, MAT_T_SINGLE, 3, 1, {0.5F, -1, 2}));
    file.write(MatioFile::variable<std::int16_t>("counts", MAT_C_INT16, MAT_T_INT16, 1, 3, {-7, 8, 9}));
    file.write(
        MatioFile::variable<std::uint64_t>("large", MAT_C_UINT64, MAT_T_UINT64, 1, 2, {1ULL << 40, 3}));
    file.sparse("sparse");
    file.structure("s");
  }
  const auto read = read_all(file.close());
  EXPECT_EQ(find(read, "matrix").dims, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(find(read, "matrix").values, (std::vector<double>{1, 2, 3, 4, 1e300, -0.1}));
  EXPECT_EQ(find(read, "x").values, std::vector<double>{7});
  EXPECT_TRUE(find(read, "phasor").complex);
  EXPECT_EQ(find(read, "note").kind, Variable::Kind::other);
  if (old) return;
  EXPECT_EQ(find(read, "short_ones").values, (std::vector<double>{0.5, -1, 2}));
  EXPECT_EQ(find(read, "counts").values, (std::vector<double>{-7, 8, 9}));
  EXPECT_EQ(find(read, "large").values, (std::vector<double>{1099511627776.0, 3}));
  EXPECT_EQ(find(read, "sparse").values, (std::vector<double>{1, 0, -3, 4.5}));
  const Variable& structure = find(read, "s");
  ASSERT_EQ(structure.fields.size(), 2u);
  EXPECT_EQ(find(structure.fields, "x").values, (std::vector<double>{1, 2}));
  EXPECT_EQ(find(structure.fields, "note").kind, Variable::Kind::other);
}

TEST_P(ReadFile, APieceOfAFileIsRefused) {
  const TemporaryDirectory directory;
  MatioFile file(directory.path() / "a.mat", GetParam().version, GetParam().compression);
  std::vector<double> values(100);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i * i % 37);
  file.doubles("matrix", 10, 10, values);
  const std::string bytes = file.close();
  for (std::size_t size = 1; size < bytes.size(); size += 1 + bytes.size() / 50) {
    if (size == 128 && GetParam().version == MAT_FT_MAT5) continue;  // a valid file without variables
    EXPECT_NE(fault(bytes.substr(0, size)), "nothing") << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, ReadFile,
                         testing::Values(Form{MAT_FT_MAT4, MAT_COMPRESSION_NONE},
                                         Form{MAT_FT_MAT5, MAT_COMPRESSION_NONE},
                                         Form{MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
                                         Form{MAT_FT_MAT73, MAT_COMPRESSION_NONE},
                                         Form{MAT_FT_MAT73, MAT_COMPRESSION_ZLIB}));

TEST(ReadFileOfNone, IsRefused) {
  EXPECT_EQ(fault(""), "is no MATLAB file, or a damaged one");
  EXPECT_EQ(fault("t_s,x_m\n0,1\n1,2\n"), "is no MATLAB file, or a damaged one");
  EXPECT_EQ(fault(std::string(4096, 'x')), "is no MATLAB file, or a damaged one");
}

/// A number in big-endian byte order.
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

TEST(ReadFileVersion4, OfTheOtherOrderOfBytes) {
  const std::string bytes = head(1000, 1, 2) + large_end_first(0.5) + large_end_first(-3.0);
  ASSERT_TRUE(is_version_4(bytes));
  EXPECT_EQ(find(read_all(bytes), "K").values, (std::vector<double>{0.5, -3}));
  EXPECT_EQ(
      find(read_all(head(1030, 2, 1) + large_end_first(std::int16_t{-2}) + large_end_first(std::int16_t{9})),
           "K")
          .values,
      (std::vector<double>{-2, 9}));
}

TEST(ReadFileVersion4, SparseMatricesAreTriples) {
  std::string bytes = head(1002, 3, 3);
  for (const double value : {1.0, 2.0, 2.0, 1.0, 2.0, 2.0, 4.0, 5.0, 0.0}) bytes += large_end_first(value);
  const auto read = read_all(bytes);
  EXPECT_EQ(find(read, "K").dims, (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(find(read, "K").values, (std::vector<double>{4, 0, 0, 5}));
  std::string outside = head(1002, 2, 3);
  for (const double value : {7.0, 2.0, 1.0, 2.0, 4.0, 0.0}) outside += large_end_first(value);
  EXPECT_EQ(fault(outside), "is damaged: a sparse matrix whose places are none");
}

TEST(ReadFileVersion4, SizesThatAreNoneAreRefused) {
  EXPECT_EQ(fault(head(1000, -1, 2)), "is damaged: a size below 0");
  EXPECT_EQ(fault(head(1000, 2000000000, 2000000000)), "holds more than 67108864 numbers in 'K'");
  EXPECT_EQ(fault(head(1000, 3, 3) + large_end_first(1.0)), "breaks off");
  EXPECT_FALSE(is_version_4("t_s,x_m,y_m,keyphasor_v\n"));
}

}  // namespace
}  // namespace rubsweep::matlab
