#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rubsweep::matlab {

/// Largest count of numbers in one file (512 MB): a few bytes of a compressed file can claim any size.
inline constexpr std::size_t most_numbers = std::size_t{1} << 26;

/// One variable of a MATLAB file.
struct Variable {
  enum class Kind { numbers, structure, other };  ///< other: text, cells, objects, functions

  std::string name{};
  Kind kind = Kind::other;
  bool complex = false;
  std::vector<std::size_t> dims{};  ///< dimensions: at least two; empty for an object
  /// Real numbers, column by column; for a sparse matrix with its zeros. Empty where they were not wanted.
  std::vector<double> values{};
  std::vector<Variable> fields{};  ///< fields of a structure, or of the first of an array of them

  bool is_real_matrix() const { return kind == Kind::numbers && !complex && dims.size() == 2; }
};

/// Whether the numbers of a variable, whose other members are already set, are to be read.
using Wanted = std::function<bool(const Variable&)>;

/// Problem of a file, and what would be allowed.
struct FileError {
  std::string wrong, allowed = "a whole MATLAB file";
};

/// Number of elements: the product of the dimensions. Throws FileError where it is above most_numbers.
std::size_t count_of(const Variable& variable);

}  // namespace rubsweep::matlab
