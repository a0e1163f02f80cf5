#pragma once

#include <hdf5.h>

#include <string_view>
#include <vector>

#include "rubsweep/maps/matlab/variable.hpp"

namespace rubsweep::matlab {

/// Functions and numbers of the library of HDF5, which no program is linked with: it brings a dozen others,
/// of the network too, and few read such files. A name may be a macro that stands for that of a version.
#define RUBSWEEP_TEXT_OF(name) #name
#define RUBSWEEP_HDF5(name) \
  decltype(&::name) name = reinterpret_cast<decltype(&::name)>(symbol(RUBSWEEP_TEXT_OF(name)))
struct Hdf5Library {
  /// Opens the library, once. Throws FileError where there is none.
  static const Hdf5Library& get();

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
  // Numbers that HDF5's own macros look up in the library.
  hid_t doubles = -1, file_access = -1;

 private:
  Hdf5Library();
  static void* symbol(const char* name);
};
#undef RUBSWEEP_HDF5
#undef RUBSWEEP_TEXT_OF

/// Variables of the bytes of a file of version 7.3, which is one of HDF5, in the order of the alphabet. The
/// library of HDF5 is opened when it is needed for the first time, says nothing itself, and loads no filters
/// of others. Throws FileError, also where there is no such library, and where a variable is a link or keeps
/// its numbers in another file.
std::vector<Variable> read_version_73(std::string_view bytes, const Wanted& wanted);

}  // namespace rubsweep::matlab
