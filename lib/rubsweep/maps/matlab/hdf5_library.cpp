#include "rubsweep/maps/matlab/hdf5_library.hpp"

#include <dlfcn.h>

#include <string>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {
namespace {

void* open_library() {
  static void* const library = dlopen(RUBSWEEP_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  return library;
}

}  // namespace

void* Hdf5Library::symbol(const char* name) {
  void* const library = open_library();
  void* found = library == nullptr ? nullptr : dlsym(library, name);
  // In a program that is linked with the same library, its numbers are those of the program.
  if (found != nullptr && dlsym(RTLD_DEFAULT, "H5open") == dlsym(library, "H5open"))
    found = dlsym(RTLD_DEFAULT, name);
  if (found == nullptr)
    throw FileError{
        std::string("is one of version 7.3, for which " RUBSWEEP_HDF5_LIBRARY) +
            (library == nullptr ? " is not installed" : " is another one"),
        "with that library, in Debian libhdf5-103-1; or a file of version 7, which MATLAB writes with "
        "save(..., '-v7')"};
  return found;
}

Hdf5Library::Hdf5Library() {
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
  doubles = *static_cast<hid_t*>(symbol("H5T_NATIVE_DOUBLE_g"));
  file_access = *static_cast<hid_t*>(symbol("H5P_CLS_FILE_ACCESS_ID_g"));
}

const Hdf5Library& Hdf5Library::get() {
  static const Hdf5Library library;
  return library;
}

}  // namespace rubsweep::matlab
