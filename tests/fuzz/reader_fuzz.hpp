#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/config/text.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline void check_message(std::string_view message) {
  require(!message.empty());
  while (!message.empty()) {
    const std::string_view line = message.substr(0, message.find('\n'));
    require(line.starts_with("fuzz.yaml:") || line.starts_with("--set "));
    for (const char c : line) require(!config::is_control(c));
    message.remove_prefix(std::min(line.size() + 1, message.size()));
  }
}

/// Whatever the bytes are, the answer of a reader is a configuration that prints and reads back as itself,
/// with the same digest, or a ConfigError made of whole printable lines. The input is the file; what follows
/// the first NUL byte is given as --set.
int check_reader(const std::uint8_t* data, std::size_t size, auto read_text, auto print, auto digest) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  std::vector<std::string> overrides;
  if (end < size) overrides.emplace_back(input.substr(end + 1));
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
