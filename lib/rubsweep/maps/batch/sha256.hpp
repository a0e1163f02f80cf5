#pragma once

#include <nettle/sha2.h>

#include <string>
#include <string_view>

namespace rubsweep::batch {

/// SHA-256 of a text that is added in pieces, equal to the output of `sha256sum`.
class Sha256 {
 public:
  Sha256() { sha256_init(&state_); }
  void add(std::string_view text);

  /// Digest of all added text, 64 hexadecimal digits. Nothing may be added afterwards.
  std::string digits();

 private:
  sha256_ctx state_;
};

std::string sha256_of(std::string_view text);  ///< Digest of a whole text.

/// HTML page with the line `<!-- sha256 DIGITS -->` inserted as its second line. The digits are the SHA-256
/// of all other lines: `sed '/^<!-- sha256 /d' FILE | sha256sum`.
std::string with_page_sum(std::string_view page);

enum class PageSum {
  right,
  wrong,
  none  ///< no checksum: an old version of the program, or another program, wrote the page
};

PageSum check_page(std::string_view page);  ///< Compares a page with its checksum. CR LF counts as LF.

/// Text with line ends LF in place of CR LF, if its first line ends in CR LF.
std::string without_carriage_returns(std::string_view text);

}  // namespace rubsweep::batch
