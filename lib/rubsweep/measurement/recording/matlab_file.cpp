#include "rubsweep/measurement/recording/matlab_file.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/matlab/read_file.hpp"
#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {
namespace {

using matlab::Variable;

/// Most channels of one matrix: a picture has more.
constexpr std::size_t most_channels = 256;

std::string why_left_out(const Variable& variable, bool in_structure) {
  if (variable.kind == Variable::Kind::structure) return in_structure ? "is a structure in a structure" : "";
  if (variable.kind == Variable::Kind::other) return "holds no numbers";
  if (variable.complex) return "is complex";
  if (variable.dims.size() != 2) return "has " + std::to_string(variable.dims.size()) + " dimensions";
  if (std::min(variable.dims[0], variable.dims[1]) > most_channels)
    return "is " + std::to_string(variable.dims[0]) + " x " + std::to_string(variable.dims[1]) +
           ", more than " + std::to_string(most_channels) + " signals";
  return "";
}

void add_variable(Channels& table, Variable& variable, const std::string& name, bool in_structure) {
  if (std::string why = why_left_out(variable, in_structure); !why.empty()) {
    table.left_out.push_back({name, std::move(why)});
    return;
  }
  for (Variable& field : variable.fields) add_variable(table, field, name + '.' + field.name, true);
  if (variable.kind != Variable::Kind::numbers) return;
  const std::size_t rows = variable.dims[0], columns = variable.dims[1];
  if (rows == 0 || columns == 0) return;
  if (rows == 1 || columns == 1) {
    table.channels.push_back({name, unit_in_ending(name), std::move(variable.values)});
    return;
  }
  const bool along_rows = columns > rows;
  for (std::size_t i = 0; i < std::min(rows, columns); ++i) {
    std::vector<double> values;
    for (std::size_t k = 0; k < std::max(rows, columns); ++k)
      values.push_back(variable.values[along_rows ? k * rows + i : i * rows + k]);
    const std::string one = name + '_' + std::to_string(i + 1);
    table.channels.push_back({one, unit_in_ending(one), std::move(values)});
  }
}

}  // namespace

Channels read_matlab_file(std::string_view bytes, const std::string& name) {
  Channels table;
  try {
    auto variables = matlab::read_variables(bytes, [](const Variable& variable) {
      return variable.is_real_matrix() && why_left_out(variable, false).empty();
    });
    for (Variable& variable : variables) add_variable(table, variable, variable.name, false);
  } catch (const matlab::FileError& error) {
    throw ConfigError(name + ": " + error.wrong + ", allowed: " + error.allowed);
  }
  std::size_t longest = 2;
  for (const Channel& channel : table.channels) longest = std::max(longest, channel.values.size());
  std::erase_if(table.channels, [&](const Channel& channel) {
    const std::size_t count = channel.values.size();
    if (count < longest)
      table.left_out.push_back(
          {channel.name, "has " + std::to_string(count) + " of " + std::to_string(longest) + " numbers"});
    return count < longest;
  });
  if (table.channels.empty())
    throw ConfigError(name + ": holds no signal" + table.left_out_text() +
                      ", allowed: real numeric vectors or matrices, or structures of them");
  return table;
}

}  // namespace rubsweep::recording
