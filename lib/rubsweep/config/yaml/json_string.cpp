#include "rubsweep/config/yaml/json_string.hpp"

#include <fmt/format.h>

namespace rubsweep::config::yaml {
namespace {

/// Control characters that JSON has a letter for, and these letters.
constexpr std::string_view controls = "\b\f\n\r\t", letters = "bfnrt";

}  // namespace

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result.append(1, '\\').append(1, c);
    } else if (const std::size_t known = controls.find(c); known != std::string_view::npos) {
      result.append(1, '\\').append(1, letters[known]);
    } else if (static_cast<unsigned char>(c) < ' ') {
      result += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string json_list(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) result.append(result.empty() ? "" : ",").append(json_string(text));
  return "[" + result + "]";
}

}  // namespace rubsweep::config::yaml
