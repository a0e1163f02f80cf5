#include "rubsweep/maps/config/yaml/number.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>
#include <system_error>

namespace rubsweep::config::yaml {
namespace {

std::string_view without_sign(std::string_view word) {
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  return word;
}

bool names_non_finite(std::string_view word) {
  word = without_sign(word);
  if (word.starts_with('.')) word.remove_prefix(1);
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<std::string_view, 3> names{"inf", "infinity", "nan"};
  return std::find(names.begin(), names.end(), lower) != names.end();
}

}  // namespace

ParsedNumber parse_number(std::string_view word) {
  const std::string_view digits = without_sign(word);
  // from_chars would take "inf", "nan" and a second sign.
  const bool starts_well = !digits.empty() && (digits[0] == '.' || (digits[0] >= '0' && digits[0] <= '9'));
  if (names_non_finite(word)) return {0, NumberError::not_finite};
  if (!starts_well) return {0, NumberError::not_a_number};
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {0, NumberError::not_a_number};
  if (error != std::errc{}) return {0, NumberError::does_not_fit};
  return {word.starts_with('-') ? -value : value, NumberError::none};
}

}  // namespace rubsweep::config::yaml
