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
  enum class Kind { numbers, structure, other };  ///< structure: also cells; other: text, objects, functions

  std::string name{};
  Kind kind = Kind::other;
  bool complex = false;
  std::vector<std::size_t> dims{};  ///< dimensions: at least two; empty for an object
  /// Real numbers, column by column; for a sparse matrix including its zeros. Empty where `wanted` excluded
  /// them.
  std::vector<double> values{};
  /// Fields of a structure, named by field_name, or cells, named by cell_name. Empty for a structure below
  /// most_depth.
  std::vector<Variable> fields{};

  bool is_real_matrix() const { return kind == Kind::numbers && !complex && dims.size() == 2; }
};

/// Largest depth of structures and cells inside others that are read.
inline constexpr int most_depth = 8;

/// Name of a field in element `one` (from 1) of an array of structures: "FIELD" in the first element,
/// "(2).FIELD" in the second.
inline std::string field_name(const std::string& field, std::size_t one) {
  return one == 1 ? field : '(' + std::to_string(one) + ")." + field;
}

inline std::string cell_name(std::size_t one) { return '{' + std::to_string(one) + '}'; }

/// Whether the numbers of a variable are to be read; everything else about the variable is known at this
/// point.
using Wanted = std::function<bool(const Variable&)>;

/// Problem of a file, and what would be allowed.
struct FileError {
  std::string wrong, allowed = "a whole MATLAB file";
};

/// Number of elements: the product of the dimensions. Throws FileError where it is above most_numbers.
std::size_t count_of(const Variable& variable);

}  // namespace rubsweep::matlab
