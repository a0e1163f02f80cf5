#include "rubsweep/maps/matlab/hdf5_library.hpp"

#include <gtest/gtest.h>

namespace rubsweep::matlab {
namespace {

TEST(Hdf5Library, ItsNumbersAreThoseOfTheHeaders) {
  const Hdf5Library& library = Hdf5Library::get();
  EXPECT_EQ(&library, &Hdf5Library::get());
  EXPECT_EQ(library.doubles, H5T_NATIVE_DOUBLE);
  EXPECT_EQ(library.file_access, H5P_FILE_ACCESS);
  EXPECT_EQ(library.H5Tget_size(library.doubles), sizeof(double));
}

}  // namespace
}  // namespace rubsweep::matlab
