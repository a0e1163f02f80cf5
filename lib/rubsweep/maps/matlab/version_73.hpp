#pragma once

#include <hdf5.h>

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Functions and variables of the HDF5 library. The library is loaded only when needed, not linked, because
/// it brings a dozen other libraries and few users read such files. A function name may be a macro for a
/// versioned name.
#define RUBSWEEP_TEXT_OF(name) #name
// NOLINTBEGIN(bugprone-macro-parentheses): the name that is declared takes none
#define RUBSWEEP_HDF5(name) \
  decltype(&::name) name = reinterpret_cast<decltype(&::name)>(symbol(RUBSWEEP_TEXT_OF(name)))
// NOLINTEND(bugprone-macro-parentheses)
struct Hdf5Library {
  static const Hdf5Library& get();  ///< Opens the library, once. Throws FileError where it is not installed.

  RUBSWEEP_HDF5(H5open);
  RUBSWEEP_HDF5(H5Eset_auto2);
  RUBSWEEP_HDF5(H5PLset_loading_state);
  RUBSWEEP_HDF5(H5Pcreate);
  RUBSWEEP_HDF5(H5Pset_fapl_core);
  RUBSWEEP_HDF5(H5Pset_file_image);
  RUBSWEEP_HDF5(H5Pget_external_count);
  RUBSWEEP_HDF5(H5Pget_layout);
  RUBSWEEP_HDF5(H5Fopen);
  RUBSWEEP_HDF5(H5Gget_info);
  RUBSWEEP_HDF5(H5Lget_name_by_idx);
  RUBSWEEP_HDF5(H5Lget_info);
  RUBSWEEP_HDF5(H5Lexists);
  RUBSWEEP_HDF5(H5Oopen);
  RUBSWEEP_HDF5(H5Iget_type);
  RUBSWEEP_HDF5(H5Idec_ref);
  RUBSWEEP_HDF5(H5Aexists);
  RUBSWEEP_HDF5(H5Aopen);
  RUBSWEEP_HDF5(H5Aread);
  RUBSWEEP_HDF5(H5Aget_type);
  RUBSWEEP_HDF5(H5Tget_size);
  RUBSWEEP_HDF5(H5Tget_class);
  RUBSWEEP_HDF5(H5Tis_variable_str);
  RUBSWEEP_HDF5(H5Dget_space);
  RUBSWEEP_HDF5(H5Dget_type);
  RUBSWEEP_HDF5(H5Dget_create_plist);
  RUBSWEEP_HDF5(H5Dget_storage_size);
  RUBSWEEP_HDF5(H5Dread);
  RUBSWEEP_HDF5(H5Rdereference2);
  RUBSWEEP_HDF5(H5Sget_simple_extent_ndims);
  RUBSWEEP_HDF5(H5Sget_simple_extent_dims);
  // Identifiers to which HDF5's own macros refer.
  hid_t doubles = -1, file_access = -1;

 private:
  Hdf5Library();
  static void* symbol(const char* name);
};
#undef RUBSWEEP_HDF5
#undef RUBSWEEP_TEXT_OF

/// Variables of a file of version 7.3, an HDF5 file, from its bytes, in alphabetical order. The HDF5 library
/// is opened at the first call, with its error messages off and without filter plugins. Throws FileError,
/// also where the library is missing, and where a variable is a link or keeps its numbers in another file.
std::vector<Variable> read_version_73(std::string_view bytes, const Wanted& wanted);

}  // namespace rubsweep::matlab
