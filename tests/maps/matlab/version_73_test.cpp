#include "rubsweep/maps/matlab/version_73.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>

#include "maps/batch/temporary_directory.hpp"
#include "maps/matlab/matio_file.hpp"

namespace rubsweep::matlab {
namespace {

/// An HDF5 file after MATLAB's header text, which a test fills.
class Hdf5File {
 public:
  explicit Hdf5File(const std::filesystem::path& path) : path_(path) {
    const hid_t made = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(made, 512);
    id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, made, H5P_DEFAULT);
    H5Pclose(made);
    const std::array<hsize_t, 2> size{2, 2};
    space = H5Screate_simple(2, size.data(), nullptr);
  }
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File() { H5Sclose(space); }

  void dataset(const char* name, hid_t type, hid_t how, const void* values) {
    const hid_t made = H5Dcreate2(id, name, type, space, H5P_DEFAULT, how, H5P_DEFAULT);
    if (values != nullptr) H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    H5Dclose(made);
  }

  std::string close() {
    H5Fclose(id);
    std::string words = "MATLAB 7.3 MAT-file, by a test";
    words.resize(124, ' ');
    words += std::string("\0\2IM", 4);
    std::fstream(path_, std::ios::binary | std::ios::in | std::ios::out) << words;
    return batch::read_whole_file(path_);
  }

  hid_t id = -1, space = -1;

 private:
  std::filesystem::path path_;
};

constexpr std::array<double, 4> numbers{1, 2, 3, 54.36627699670272};

class Version73 : public testing::Test {
 protected:
  void SetUp() override {
    Hdf5File other(directory_.path() / "other.mat");
    other.dataset("K", H5T_NATIVE_DOUBLE, H5P_DEFAULT, numbers.data());
    other.close();
  }
  const TemporaryDirectory directory_;
  Hdf5File file_{directory_.path() / "a.mat"};
};

TEST_F(Version73, ReadsItsOwnNumbersOfAnyWidthAndOrder) {
  file_.dataset("K", H5T_NATIVE_DOUBLE, H5P_DEFAULT, numbers.data());
  const std::array<float, 4> singles{1, 2, 3, 4};
  file_.dataset("M", H5T_NATIVE_FLOAT, H5P_DEFAULT, singles.data());
  const std::array<std::uint32_t, 4> swapped{0x01000000, 0x02000000, 0x03000000, 0x04000000};
  file_.dataset("N", H5T_STD_U32BE, H5P_DEFAULT, swapped.data());
  const auto read = read_all(file_.close());
  EXPECT_EQ(find(read, "K").values, std::vector<double>(numbers.begin(), numbers.end()));
  EXPECT_EQ(find(read, "M").values, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(find(read, "N").values, (std::vector<double>{1, 2, 3, 4}));
}

TEST_F(Version73, IsReadWhateverFilesAreThere) {
  file_.dataset("K", H5T_NATIVE_DOUBLE, H5P_DEFAULT, numbers.data());
  const std::string bytes = file_.close();
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(directory_.path());
  std::ofstream("matlab") << "of somebody";
  EXPECT_EQ(fault(bytes), "nothing");
  std::filesystem::current_path(before);
}

TEST_F(Version73, NumbersInOtherFilesAreRefusedByName) {
  const hid_t outside = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(outside, (directory_.path() / "other.mat").c_str(), 0, 32);
  file_.dataset("stiffness", H5T_NATIVE_DOUBLE, outside, nullptr);
  H5Pclose(outside);
  EXPECT_EQ(fault(file_.close()), "leads elsewhere: the numbers of 'stiffness' are in another file");
}

TEST_F(Version73, NumbersMappedFromOtherFilesAreRefusedByName) {
  const hid_t mapped = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_virtual(mapped, file_.space, (directory_.path() / "other.mat").c_str(), "K", file_.space);
  file_.dataset("stiffness", H5T_NATIVE_DOUBLE, mapped, nullptr);
  H5Pclose(mapped);
  EXPECT_EQ(fault(file_.close()), "leads elsewhere: the numbers of 'stiffness' are in another file");
}

TEST_F(Version73, LinksAreRefusedByName) {
  H5Lcreate_external((directory_.path() / "other.mat").c_str(), "/K", file_.id, "K", H5P_DEFAULT,
                     H5P_DEFAULT);
  EXPECT_EQ(fault(file_.close()), "leads elsewhere: 'K' is a link, to another file");
}

TEST_F(Version73, SoftLinksInStructuresAreRefusedByName) {
  const hid_t group = H5Gcreate2(file_.id, "signals", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/elsewhere", group, "x", H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(group);
  EXPECT_EQ(fault(file_.close()), "leads elsewhere: 'x' is a link, a soft one");
}

TEST_F(Version73, NumbersThatWereNeverWrittenAreNotZeros) {
  file_.dataset("K", H5T_NATIVE_DOUBLE, H5P_DEFAULT, nullptr);
  EXPECT_EQ(fault(file_.close()), "is damaged: 'K' cannot be read");
}

TEST_F(Version73, SizesWithoutEndAreRefused) {
  const std::array<hsize_t, 2> size{1ULL << 40, 1ULL << 20}, piece{16, 16};
  const hid_t large = H5Screate_simple(2, size.data(), nullptr), chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 2, piece.data());
  H5Dclose(H5Dcreate2(file_.id, "K", H5T_NATIVE_DOUBLE, large, H5P_DEFAULT, chunked, H5P_DEFAULT));
  H5Pclose(chunked);
  H5Sclose(large);
  EXPECT_EQ(fault(file_.close()), "holds more than 67108864 numbers in 'K'");
}

TEST_F(Version73, ADamagedFileIsRefusedAndTheLibrarySaysNothing) {
  file_.dataset("K", H5T_NATIVE_DOUBLE, H5P_DEFAULT, numbers.data());
  const std::string bytes = file_.close();
  testing::internal::CaptureStderr();
  int refused = 0;
  for (std::size_t i = 512; i < bytes.size(); i += 3) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x40);
    refused += fault(changed) != "nothing";
  }
  EXPECT_GT(refused, 10);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Version73Hdf5Library, ItsNumbersAreThoseOfTheHeaders) {
  const Hdf5Library& library = Hdf5Library::get();
  EXPECT_EQ(&library, &Hdf5Library::get());
  EXPECT_EQ(library.doubles, H5T_NATIVE_DOUBLE);
  EXPECT_EQ(library.file_access, H5P_FILE_ACCESS);
  EXPECT_EQ(library.H5Tget_size(library.doubles), sizeof(double));
}

}  // namespace
}  // namespace rubsweep::matlab
