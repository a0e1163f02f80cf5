#include "rubsweep/maps/matlab/read_file.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "rubsweep/maps/matlab/bytes.hpp"
#include "rubsweep/maps/matlab/version_5.hpp"
#include "rubsweep/maps/matlab/version_73.hpp"

namespace rubsweep::matlab {
namespace {

/// Types of numbers by the digit P of the type code MOPT of version 4.
constexpr std::array<Stored, 6> stored_types{Stored::float64, Stored::float32, Stored::int32,
                                             Stored::int16,   Stored::uint16,  Stored::uint8};

struct Type {
  int order = 0, reserved = 0, precision = 0, kind = 0;
  bool is_sound() const {
    return order <= 1 && reserved == 0 && precision < static_cast<int>(stored_types.size()) && kind <= 2;
  }
};

Type type_of(std::int32_t mopt) {
  if (mopt < 0) return {2};
  return {mopt / 1000, mopt / 100 % 10, mopt / 10 % 10, mopt % 10};
}

/// Reads a sparse matrix: lines of row, column and value. The last line gives the size of the matrix.
void read_sparse(Variable& variable, std::size_t rows, const std::vector<double>& table,
                 const Wanted& wanted) {
  const auto at = [&](std::size_t row, std::size_t column) { return table[column * rows + row]; };
  const double high = at(rows - 1, 0), wide = at(rows - 1, 1);
  if (!(high >= 0 && wide >= 0 && high <= most_numbers && wide <= most_numbers))
    throw FileError{"is damaged: a sparse matrix without a size"};
  variable.dims = {static_cast<std::size_t>(high), static_cast<std::size_t>(wide)};
  if (!wanted(variable)) return;
  variable.values.assign(count_of(variable), 0.0);
  for (std::size_t k = 0; k + 1 < rows; ++k) {
    const double row = at(k, 0), column = at(k, 1);
    if (!(row >= 1 && row <= high && column >= 1 && column <= wide))
      throw FileError{"is damaged: a sparse matrix whose places are none"};
    variable.values[(static_cast<std::size_t>(column) - 1) * variable.dims[0] +
                    static_cast<std::size_t>(row) - 1] += at(k, 2);
  }
}

/// Reads the variables of a file of version 4. Throws FileError.
std::vector<Variable> read_version_4(std::string_view bytes, const Wanted& wanted) {
  const Type first = type_of(Bytes(bytes, false).number<std::int32_t>());
  Bytes in(bytes, !(first.is_sound() && first.order == 0));
  std::vector<Variable> variables;
  while (in.left() > 0) {
    const Type type = type_of(in.number<std::int32_t>());
    std::array<std::int32_t, 4> head{};  // rows, columns, 1 if complex, length of the name
    for (std::int32_t& number : head) {
      number = in.number<std::int32_t>();
      if (number < 0) throw FileError{"is damaged: a size below 0"};
    }
    if (!type.is_sound()) throw FileError{"is damaged: a variable of an unknown type"};
    const std::string_view name = in.take(static_cast<std::size_t>(head[3]));
    Variable variable{.name = std::string(name.substr(0, name.find('\0'))), .complex = head[2] != 0};
    variable.dims = {static_cast<std::size_t>(head[0]), static_cast<std::size_t>(head[1])};
    if (type.kind != 1) variable.kind = Variable::Kind::numbers;
    const std::size_t count = count_of(variable);
    std::vector<double> values =
        take_numbers(in, stored_types[static_cast<std::size_t>(type.precision)], count);
    if (variable.complex && type.kind != 2)
      take_numbers(in, stored_types[static_cast<std::size_t>(type.precision)], count);
    if (type.kind == 2) {
      variable.complex = variable.dims[1] == 4;
      if (variable.dims[0] < 1 || variable.dims[1] < 3)
        throw FileError{"is damaged: a sparse matrix without a size"};
      read_sparse(variable, variable.dims[0], values, wanted);
    } else if (type.kind == 0 && wanted(variable)) {
      variable.values = std::move(values);
    }
    variables.push_back(std::move(variable));
  }
  return variables;
}

}  // namespace

std::size_t count_of(const Variable& variable) {
  std::size_t count = 1;
  for (const std::size_t size : variable.dims) {
    if (size > 0 && count > most_numbers / size)
      throw FileError{
          "holds more than " + std::to_string(most_numbers) + " numbers in '" + variable.name + '\'',
          "at most so many"};
    count *= size;
  }
  return count;
}

std::vector<Variable> read_variables(std::string_view bytes, const Wanted& wanted) {
  constexpr std::size_t head = 128;
  if (bytes.size() >= head && (bytes.substr(126, 2) == "IM" || bytes.substr(126, 2) == "MI")) {
    const bool swapped = bytes[126] == 'M';
    const auto version = Bytes(bytes.substr(124, 2), swapped).number<std::uint16_t>();
    if (version == 0x0100) return read_version_5(Bytes(bytes.substr(head), swapped), wanted);
    if (version == 0x0200) return read_version_73(bytes, wanted);
  } else if (is_version_4(bytes)) {
    return read_version_4(bytes, wanted);
  }
  throw FileError{"is no MATLAB file, or a damaged one", "a file of version 4, 5 or 7.3"};
}

bool is_version_4(std::string_view bytes) {
  constexpr std::size_t head = 20;
  if (bytes.size() < head) return false;
  const Type little = type_of(Bytes(bytes, false).number<std::int32_t>()),
             big = type_of(Bytes(bytes, true).number<std::int32_t>());
  return (little.is_sound() && little.order == 0) || (big.is_sound() && big.order == 1);
}

}  // namespace rubsweep::matlab
