#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace rubsweep::batch {

/// SHA-256 of a text that is added in pieces (FIPS 180-4), equal to the output of `sha256sum`.
class Sha256 {
 public:
  void add(std::string_view text);

  /// Digest of all added text, as 64 hexadecimal digits. Nothing may be added afterwards.
  std::string digits();

 private:
  void take_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> waiting_{};  ///< bytes of an incomplete block
  std::uint64_t bytes_ = 0;
};

/// Digest of a whole text.
std::string sha256_of(std::string_view text);

/// HTML page with the line `<!-- sha256 DIGITS -->` inserted as its second line. The digits are the SHA-256
/// of all other lines: `sed '/^<!-- sha256 /d' FILE | sha256sum`.
std::string with_page_sum(std::string_view page);

enum class PageSum {
  right,
  wrong,
  none  ///< no checksum: an old version of the program, or another program, wrote the page
};

/// Compares a page with its checksum. Line ends CR LF count as LF.
PageSum check_page(std::string_view page);

/// Text with line ends LF in place of CR LF, if its first line ends in CR LF.
std::string without_carriage_returns(std::string_view text);

}  // namespace rubsweep::batch
