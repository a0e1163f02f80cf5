#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Whether a line begins like "file:12:3: ...", whatever file the input named as its base.
inline bool names_a_place(std::string_view line) {
  const auto skip_number = [&](std::size_t at) { return line.find_first_not_of("0123456789", at); };
  for (std::size_t colon = line.find(':'); colon != line.npos; colon = line.find(':', colon + 1)) {
    const std::size_t second = skip_number(colon + 1);
    if (second == line.npos || second == colon + 1 || line[second] != ':') continue;
    const std::size_t third = skip_number(second + 1);
    if (third != line.npos && third > second + 1 && line.substr(third).starts_with(": ")) return true;
  }
  return false;
}

/// Writes `text` as base.yaml into the working directory, a temporary one.
inline void write_base(std::string_view text) {
  static const bool moved = [] {
    std::string name = (std::filesystem::temp_directory_path() / "rubsweep-fuzz-XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr);
    std::filesystem::current_path(name);
    return true;
  }();
  require(moved);
  std::ofstream("base.yaml", std::ios::binary) << text;
}

inline void check_message(std::string_view message) {
  require(!message.empty());
  while (!message.empty()) {
    const std::string_view line = message.substr(0, message.find('\n'));
    require(line.starts_with("fuzz.yaml:") || line.starts_with("--set ") || names_a_place(line));
    for (const char c : line) require(!config::yaml::is_control(c));
    message.remove_prefix(std::min(line.size() + 1, message.size()));
  }
}

/// For any bytes, the reader must return a configuration that prints and reads back as itself with the same
/// digest, or throw a ConfigError with whole printable lines. The input is the file; the part after the first
/// NUL byte becomes --set, the part after the second one becomes base.yaml beside the file.
int check_reader(const std::uint8_t* data, std::size_t size, auto read_text, auto print, auto digest) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  const std::string_view rest = input.substr(std::min(end + 1, size));
  const std::size_t end_of_override = std::min(rest.find('\0'), rest.size());
  std::vector<std::string> overrides;
  if (end < size) overrides.emplace_back(rest.substr(0, end_of_override));
  write_base(rest.substr(std::min(end_of_override + 1, rest.size())));
  decltype(read_text(input, "", overrides)) read;
  try {
    read = read_text(input.substr(0, end), "fuzz.yaml", overrides);
  } catch (const ConfigError& error) {
    check_message(error.what());
    return 0;
  }
  const std::string printed = print(read);
  const auto again = read_text(printed, "printed.yaml", {});
  require(print(again) == printed);
  require(digest(again.study) == digest(read.study));
  return 0;
}

}  // namespace rubsweep::fuzz
