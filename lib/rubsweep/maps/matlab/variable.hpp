#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rubsweep::matlab {

/// Most numbers that one file may hold, 512 MB of them: a few bytes of a compressed file can claim any size.
inline constexpr std::size_t most_numbers = std::size_t{1} << 26;

/// Variable of a MATLAB file.
struct Variable {
  enum class Kind { numbers, structure, other };  ///< other: text, cells, objects, functions

  std::string name{};
  Kind kind = Kind::other;
  bool complex = false;
  std::vector<std::size_t> dims{};  ///< dimensions: at least two, but none of an object
  /// Real numbers, column by column, of a sparse matrix its zeros as well; empty where nobody wanted them.
  std::vector<double> values{};
  std::vector<Variable> fields{};  ///< fields of the first one of an array of structures

  bool is_real_matrix() const { return kind == Kind::numbers && !complex && dims.size() == 2; }
};

/// Whether the numbers of a variable, of which all else is known, are to be read.
using Wanted = std::function<bool(const Variable&)>;

/// Fault of a file, and what would be right.
struct FileError {
  std::string wrong, allowed = "a whole MATLAB file";
};

/// Product of the dimensions. Throws FileError where it is above most_numbers.
std::size_t count_of(const Variable& variable);

}  // namespace rubsweep::matlab
