#include "rubsweep/maps/batch/sha256.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubsweep::batch {
namespace {

constexpr std::string_view before_digits = "<!-- sha256 ", behind_digits = " -->\n";

}  // namespace

void Sha256::add(std::string_view text) {
  sha256_update(&state_, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
}

std::string Sha256::digits() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes;
  sha256_digest(&state_, bytes.size(), bytes.data());
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

std::string sha256_of(std::string_view text) {
  Sha256 sum;
  sum.add(text);
  return sum.digits();
}

std::string with_page_sum(std::string_view page) {
  const std::size_t after_first = std::min(page.find('\n'), page.size() - 1) + 1;
  return std::string(page.substr(0, after_first))
      .append(before_digits)
      .append(sha256_of(page))
      .append(behind_digits)
      .append(page.substr(after_first));
}

PageSum check_page(std::string_view page) {
  const std::string text = without_carriage_returns(page);
  const std::size_t line = std::min(text.find('\n'), text.size() - 1) + 1;
  const std::string_view marked = std::string_view(text).substr(line);
  if (!marked.starts_with(before_digits)) return PageSum::none;
  const std::size_t length = std::min(marked.find('\n'), marked.size() - 1) + 1;
  const std::string other = text.substr(0, line).append(marked.substr(length));
  const bool same =
      marked.substr(0, length) == std::string(before_digits).append(sha256_of(other)).append(behind_digits);
  return same ? PageSum::right : PageSum::wrong;
}

std::string without_carriage_returns(std::string_view text) {
  const std::size_t first = text.find('\n');
  if (first == std::string_view::npos || first == 0 || text[first - 1] != '\r') return std::string(text);
  std::string same;
  same.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!text.substr(i).starts_with("\r\n")) same += text[i];
  return same;
}

}  // namespace rubsweep::batch
