#include "rubsweep/maps/matlab/version_73.hpp"

#include <dlfcn.h>

#include <cstdint>
#include <string>
#include <utility>

#include "rubsweep/maps/matlab/bytes.hpp"

namespace rubsweep::matlab {
namespace {

void* open_library() {
  static void* const library = dlopen(RUBSWEEP_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  return library;
}

/// Owns a file, object or type of HDF5, each of which has a numeric identifier.
class Handle {
 public:
  Handle(const Hdf5Library& library, hid_t id) : library_(library), id_(id) {
    if (id < 0) throw FileError{"is damaged: HDF5 cannot read all of it"};
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { library_.H5Idec_ref(id_); }
  operator hid_t() const { return id_; }

 private:
  const Hdf5Library& library_;
  hid_t id_;
};

class Reader {
 public:
  Reader(const Hdf5Library& library, const Wanted& wanted) : h5_(library), wanted_(wanted) {}

  std::vector<Variable> read_group(hid_t group, int depth) {
    std::vector<Variable> variables;
    for (const std::string& name : names_in(group)) {
      if (name.starts_with('#')) continue;  // contents of cells and objects of MATLAB
      const Handle object = open(group, name);
      if (depth > 0 && refers(object) && !is_class(object, "cell")) {  // a field of an array of structures
        std::size_t place = 0;
        for (Variable& one : referred(object, depth)) {
          one.name = field_name(name, ++place);
          variables.push_back(std::move(one));
        }
      } else {
        variables.push_back(read_object(object, name, depth));
      }
    }
    return variables;
  }

 private:
  Variable read_object(hid_t object, const std::string& name, int depth) {
    constexpr std::size_t most_variables = 100000;
    if (++variables_ > most_variables) throw FileError{"holds more than 100000 variables", "fewer"};
    Variable variable{.name = name};
    const H5I_type_t type = h5_.H5Iget_type(object);
    if (type == H5I_GROUP && has(object, "MATLAB_sparse")) {
      read_sparse(object, variable);
    } else if (type == H5I_GROUP) {
      variable.kind = Variable::Kind::structure;
      variable.dims = {1, 1};
      if (depth < most_depth) variable.fields = read_group(object, depth + 1);
    } else if (type == H5I_DATASET && refers(object) && is_class(object, "cell")) {
      variable.kind = Variable::Kind::structure;
      variable.dims = dims_of(object);
      if (depth < most_depth) variable.fields = referred(object, depth);
    } else if (type == H5I_DATASET) {
      read_dataset(object, variable);
    }
    return variable;
  }

  bool refers(hid_t object) const {
    if (h5_.H5Iget_type(object) != H5I_DATASET) return false;
    const Handle type{h5_, h5_.H5Dget_type(object)};
    return h5_.H5Tget_class(type) == H5T_REFERENCE && h5_.H5Tget_size(type) == sizeof(hobj_ref_t);
  }

  /// Objects that a dataset of references refers to, each named as a cell.
  std::vector<Variable> referred(hid_t dataset, int depth) {
    const Handle type{h5_, h5_.H5Dget_type(dataset)};
    std::vector<hobj_ref_t> references(count_of({.name = "a cell", .dims = dims_of(dataset)}));
    if (references.empty()) return {};
    require_own_numbers(dataset, "a cell");
    require(h5_.H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) >= 0, "a cell");
    std::vector<Variable> variables;
    for (std::size_t k = 0; k < references.size(); ++k) {
      const Handle object{h5_, h5_.H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, &references[k])};
      variables.push_back(read_object(object, cell_name(k + 1), depth + 1));
    }
    return variables;
  }

  void require(bool sound, const std::string& name) const {
    if (!sound) throw FileError{"is damaged: '" + name + "' cannot be read"};
  }

  std::vector<std::string> names_in(hid_t group) const {
    H5G_info_t facts{};
    require(h5_.H5Gget_info(group, &facts) >= 0, "a group");
    std::vector<std::string> names;
    for (hsize_t i = 0; i < facts.nlinks; ++i) {
      const auto name_of = [&](char* text, std::size_t size) {
        return h5_.H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size, H5P_DEFAULT);
      };
      const auto length = name_of(nullptr, 0);
      require(length > 0, "a name");
      std::string name(static_cast<std::size_t>(length) + 1, '\0');
      name_of(name.data(), name.size());
      name.pop_back();
      names.push_back(std::move(name));
    }
    return names;
  }

  /// Opens an object that is in the group itself, not a link.
  Handle open(hid_t group, const std::string& name) const {
    H5L_info_t facts{};
    require(h5_.H5Lget_info(group, name.c_str(), &facts, H5P_DEFAULT) >= 0, name);
    if (facts.type != H5L_TYPE_HARD)
      throw FileError{"leads elsewhere: '" + name + "' is a link, " +
                          (facts.type == H5L_TYPE_SOFT ? "a soft one" : "to another file"),
                      "a file that holds its variables itself"};
    return {h5_, h5_.H5Oopen(group, name.c_str(), H5P_DEFAULT)};
  }

  bool has(hid_t object, const char* attribute) const { return h5_.H5Aexists(object, attribute) > 0; }

  bool is_class(hid_t object, std::string_view name) const {
    if (!has(object, "MATLAB_class")) return false;
    const Handle attribute{h5_, h5_.H5Aopen(object, "MATLAB_class", H5P_DEFAULT)};
    const Handle type{h5_, h5_.H5Aget_type(attribute)};
    constexpr std::size_t longest = 100;
    const std::size_t size = h5_.H5Tget_size(type);
    if (h5_.H5Tget_class(type) != H5T_STRING || h5_.H5Tis_variable_str(type) != 0 || size > longest)
      return false;
    std::string word(size, '\0');
    return h5_.H5Aread(attribute, type, word.data()) >= 0 && word.starts_with(name);
  }

  /// Dimensions in MATLAB's order, the reverse of HDF5's.
  std::vector<std::size_t> dims_of(hid_t dataset) const {
    const Handle space{h5_, h5_.H5Dget_space(dataset)};
    const int rank = h5_.H5Sget_simple_extent_ndims(space);
    if (rank < 0 || rank > H5S_MAX_RANK) throw FileError{"is damaged: an array of no size"};
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    h5_.H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    std::vector<std::size_t> dims(sizes.rbegin(), sizes.rend());
    while (dims.size() < 2) dims.push_back(1);
    return dims;
  }

  void require_own_numbers(hid_t dataset, const std::string& name) const {
    const Handle made{h5_, h5_.H5Dget_create_plist(dataset)};
    if (h5_.H5Pget_external_count(made) != 0 || h5_.H5Pget_layout(made) == H5D_VIRTUAL)
      throw FileError{"leads elsewhere: the numbers of '" + name + "' are in another file",
                      "a file that holds its variables itself"};
    require(h5_.H5Dget_storage_size(dataset) > 0, name);
  }

  std::vector<double> numbers_of(hid_t dataset, const Variable& head) const {
    std::vector<double> values(count_of(head));
    if (values.empty()) return values;
    require_own_numbers(dataset, head.name);
    require(h5_.H5Dread(dataset, h5_.doubles, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, head.name);
    return values;
  }

  void read_dataset(hid_t dataset, Variable& variable) const {
    const Handle type{h5_, h5_.H5Dget_type(dataset)};
    const H5T_class_t kind = h5_.H5Tget_class(type);
    variable.dims = dims_of(dataset);
    variable.complex = kind == H5T_COMPOUND;
    const bool numbers = kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_COMPOUND;
    if (!numbers || has(dataset, "MATLAB_empty") || is_class(dataset, "char")) return;
    variable.kind = Variable::Kind::numbers;
    if (!variable.complex && wanted_(variable)) variable.values = numbers_of(dataset, variable);
  }

  /// Reads a sparse matrix: a group of values, their rows, and the index of the first value of each column.
  void read_sparse(hid_t group, Variable& variable) const {
    std::uint64_t rows = 0;
    const Handle attribute{h5_, h5_.H5Aopen(group, "MATLAB_sparse", H5P_DEFAULT)};
    const Handle type{h5_, h5_.H5Aget_type(attribute)};
    require(h5_.H5Tget_size(type) == sizeof rows && h5_.H5Aread(attribute, type, &rows) >= 0, variable.name);
    const auto part = [&](const char* name) {
      if (h5_.H5Lexists(group, name, H5P_DEFAULT) <= 0)
        return std::vector<double>();  // for a matrix of zeros this data set is missing
      const Handle dataset = open(group, name);
      require(h5_.H5Iget_type(dataset) == H5I_DATASET, variable.name);
      const Handle kind{h5_, h5_.H5Dget_type(dataset)};
      variable.complex = variable.complex || h5_.H5Tget_class(kind) == H5T_COMPOUND;
      return variable.complex ? std::vector<double>()
                              : numbers_of(dataset, {.name = variable.name, .dims = dims_of(dataset)});
    };
    const std::vector<double> begin = part("jc");
    require(!begin.empty(), variable.name);
    variable.kind = Variable::Kind::numbers;
    variable.dims = {rows, begin.size() - 1};
    const std::vector<double> row = part("ir"), stored = part("data");
    if (!variable.complex && wanted_(variable)) variable.values = full_matrix(variable, row, begin, stored);
  }

  const Hdf5Library& h5_;
  const Wanted& wanted_;
  std::size_t variables_ = 0;
};

}  // namespace

void* Hdf5Library::symbol(const char* name) {
  void* const library = open_library();
  void* found = library == nullptr ? nullptr : dlsym(library, name);
  // In a program that is linked with the same library, its own copies of the variables are used.
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

std::vector<Variable> read_version_73(std::string_view bytes, const Wanted& wanted) {
  const Hdf5Library& library = Hdf5Library::get();
  const Handle access{library, library.H5Pcreate(library.file_access)};
  constexpr std::size_t step = 1 << 16;
  if (library.H5Pset_fapl_core(access, step, false) < 0 ||
      library.H5Pset_file_image(access, const_cast<char*>(bytes.data()), bytes.size()) < 0)
    throw FileError{"cannot be read by HDF5"};
  // HDF5 reads the bytes in memory, but it needs a file name that does not exist.
  const Handle file{library, library.H5Fopen("/dev/null/matlab", 0, access)};
  return Reader(library, wanted).read_group(file, 0);
}

}  // namespace rubsweep::matlab
