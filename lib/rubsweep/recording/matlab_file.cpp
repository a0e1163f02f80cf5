#include "rubsweep/recording/matlab_file.hpp"

#include <matio.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "rubsweep/error.hpp"
#include "rubsweep/recording/name_unit.hpp"

namespace rubsweep::recording {
namespace {

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

/// Most channels of one file: a picture or a table that was saved turned on its side has more.
constexpr std::size_t most_columns = 256;

template <class Number>
std::vector<double> numbers_of(const matvar_t& variable, std::size_t begin, std::size_t count) {
  const auto* values = static_cast<const Number*>(variable.data) + begin;
  std::vector<double> numbers;
  for (const Number value : std::span(values, count)) numbers.push_back(static_cast<double>(value));
  return numbers;
}

/// Part of a variable's numbers; none where it has no real numbers.
std::vector<double> column_of(const matvar_t& variable, std::size_t begin, std::size_t count) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return numbers_of<double>(variable, begin, count);
    case MAT_C_SINGLE:
      return numbers_of<float>(variable, begin, count);
    case MAT_C_INT8:
      return numbers_of<std::int8_t>(variable, begin, count);
    case MAT_C_UINT8:
      return numbers_of<std::uint8_t>(variable, begin, count);
    case MAT_C_INT16:
      return numbers_of<std::int16_t>(variable, begin, count);
    case MAT_C_UINT16:
      return numbers_of<std::uint16_t>(variable, begin, count);
    case MAT_C_INT32:
      return numbers_of<std::int32_t>(variable, begin, count);
    case MAT_C_UINT32:
      return numbers_of<std::uint32_t>(variable, begin, count);
    case MAT_C_INT64:
      return numbers_of<std::int64_t>(variable, begin, count);
    case MAT_C_UINT64:
      return numbers_of<std::uint64_t>(variable, begin, count);
    default:
      return {};
  }
}

void add_channel(Channels& table, const std::string& name, std::vector<double> values) {
  if (values.size() < 2) return;
  table.channels.push_back({name, unit_in_ending(name), std::move(values)});
}

void add_variable(Channels& table, const matvar_t& variable, const std::string& name,
                  const std::string& file) {
  if (variable.class_type == MAT_C_STRUCT) {
    const unsigned fields = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable));
    char* const* names = Mat_VarGetStructFieldnames(&variable);
    for (unsigned i = 0; i < fields && names != nullptr; ++i) {
      const matvar_t* field = Mat_VarGetStructFieldByIndex(const_cast<matvar_t*>(&variable), i, 0);
      if (field != nullptr && field->class_type != MAT_C_STRUCT)
        add_variable(table, *field, name + '.' + names[i], file);
    }
    return;
  }
  if (variable.rank != 2 || variable.isComplex != 0 || variable.dims == nullptr) return;
  const std::size_t rows = variable.dims[0], columns = variable.dims[1];
  if (rows == 0 || columns == 0) return;
  const bool numeric = variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64;
  if (!numeric) return;
  if (variable.data == nullptr ||
      variable.nbytes < rows * columns * static_cast<std::size_t>(variable.data_size))
    throw ConfigError(file + ": '" + name + "' breaks off, allowed: a whole MATLAB file");
  if (rows == 1 || columns == 1) return add_channel(table, name, column_of(variable, 0, rows * columns));
  if (columns > most_columns) return;
  for (std::size_t i = 0; i < columns; ++i)
    add_channel(table, name + '_' + std::to_string(i + 1), column_of(variable, i * rows, rows));
}

}  // namespace

Channels read_matlab_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::unique_ptr<mat_t, CloseFile> open(Mat_Open(name.c_str(), MAT_ACC_RDONLY));
  if (!open) throw ConfigError(name + ": is damaged, allowed: a MATLAB file of version 4, 5 or 7.3");
  Channels table;
  while (const Variable variable{Mat_VarReadNext(open.get())})
    add_variable(table, *variable, variable->name == nullptr ? "" : variable->name, name);
  std::size_t longest = 0;
  for (const Channel& channel : table.channels) longest = std::max(longest, channel.values.size());
  std::erase_if(table.channels, [&](const Channel& channel) { return channel.values.size() < longest; });
  if (table.channels.empty())
    throw ConfigError(name +
                      ": holds no signal, allowed: real numeric vectors or matrices, or structures of them");
  return table;
}

}  // namespace rubsweep::recording
