#pragma once

#include <gtest/gtest.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "maps/batch/read_whole_file.hpp"
#include "rubsweep/maps/matlab/read_file.hpp"

namespace rubsweep::matlab {

/// A MATLAB file written by libmatio, variable by variable.
class MatioFile {
 public:
  MatioFile(std::filesystem::path path, mat_ft version, matio_compression compression = MAT_COMPRESSION_NONE)
      : path_(std::move(path)),
        file_(Mat_CreateVer(path_.c_str(), nullptr, version)),
        compression_(compression) {}
  ~MatioFile() { close(); }
  MatioFile(const MatioFile&) = delete;
  MatioFile& operator=(const MatioFile&) = delete;

  template <class Number>
  static matvar_t* variable(const char* name, matio_classes kind, matio_types type, std::size_t rows,
                            std::size_t columns, std::vector<Number> values) {
    std::array<std::size_t, 2> dims{rows, columns};
    return Mat_VarCreate(name, kind, type, 2, dims.data(), values.data(), 0);
  }
  void doubles(const char* name, std::size_t rows, std::size_t columns, std::vector<double> values) {
    write(variable(name, MAT_C_DOUBLE, MAT_T_DOUBLE, rows, columns, std::move(values)));
  }
  void phasor(const char* name) {
    std::array<std::size_t, 2> dims{1, 1};
    double real = 1, imaginary = 2;
    mat_complex_split_t both{&real, &imaginary};
    write(Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims.data(), &both, MAT_F_COMPLEX));
  }
  void text(const char* name) { write(variable<char>(name, MAT_C_CHAR, MAT_T_UINT8, 1, 3, {'a', 'b', 'c'})); }
  /// Writes the sparse matrix {{1, -3}, {0, 4.5}}.
  void sparse(const char* name) {
    std::array<std::size_t, 2> size{2, 2};
    std::array<mat_uint32_t, 3> rows{0, 0, 1}, begins{0, 1, 3};
    std::array<double, 3> values{1, -3, 4.5};
    mat_sparse_t stored{};
    stored.nzmax = stored.nir = stored.ndata = 3;
    stored.ir = rows.data(), stored.njc = 3, stored.jc = begins.data(), stored.data = values.data();
    write(Mat_VarCreate(name, MAT_C_SPARSE, MAT_T_DOUBLE, 2, size.data(), &stored, MAT_F_DONT_COPY_DATA));
  }
  /// Writes a structure with x, a vector of 1 and 2, and note, a text.
  void structure(const char* name) {
    std::array<const char*, 2> names{"x", "note"};
    std::array<std::size_t, 2> size{1, 1};
    matvar_t* made = Mat_VarCreateStruct(name, 2, size.data(), names.data(), 2);
    Mat_VarSetStructFieldByName(made, "x", 0,
                                variable<double>("x", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, 1, {1, 2}));
    Mat_VarSetStructFieldByName(made, "note", 0,
                                variable<char>("note", MAT_C_CHAR, MAT_T_UINT8, 1, 1, {'a'}));
    write(made);
  }
  void write(matvar_t* made) {
    ASSERT_NE(made, nullptr);
    ASSERT_EQ(Mat_VarWrite(file_, made, compression_), 0);
    Mat_VarFree(made);
  }

  /// Closes the file and returns its bytes.
  std::string close() {
    if (file_ != nullptr) Mat_Close(file_);
    file_ = nullptr;
    return batch::read_whole_file(path_);
  }

 private:
  std::filesystem::path path_;
  mat_t* file_;
  matio_compression compression_;
};

inline std::vector<Variable> read_all(std::string_view bytes) {
  return read_variables(bytes, [](const Variable& one) { return one.is_real_matrix(); });
}

inline const Variable& find(const std::vector<Variable>& variables, const std::string& name) {
  return *std::ranges::find(variables, name, &Variable::name);
}

/// The fault found in the bytes, or "nothing".
inline std::string fault(std::string_view bytes) {
  try {
    read_all(bytes);
  } catch (const FileError& error) {
    return error.wrong;
  }
  return "nothing";
}

}  // namespace rubsweep::matlab
