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
  /// Real numbers, column by column; for a sparse matrix with its zeros. Empty where they were not wanted.
  std::vector<double> values{};
  /// Fields of a structure, by field_name, or cells, by cell_name; none of one that lies too deep.
  std::vector<Variable> fields{};

  bool is_real_matrix() const { return kind == Kind::numbers && !complex && dims.size() == 2; }
};

/// Structures and cells in others that are read.
inline constexpr int most_depth = 8;

/// Name of a field in element `one` (from 1) of an array of structures: "FIELD" in the first element,
/// "(2).FIELD" in the second.
inline std::string field_name(const std::string& field, std::size_t one) {
  return one == 1 ? field : '(' + std::to_string(one) + ")." + field;
}

inline std::string cell_name(std::size_t one) { return '{' + std::to_string(one) + '}'; }

/// Whether the numbers of a variable, of which all else is known, are to be read.
using Wanted = std::function<bool(const Variable&)>;

/// Problem of a file, and what would be allowed.
struct FileError {
  std::string wrong, allowed = "a whole MATLAB file";
};

/// Number of elements: the product of the dimensions. Throws FileError where it is above most_numbers.
std::size_t count_of(const Variable& variable);

}  // namespace rubsweep::matlab
