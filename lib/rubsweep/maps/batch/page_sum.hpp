#pragma once

#include <string>
#include <string_view>

namespace rubsweep::batch {

/// A page of HTML with the line `<!-- sha256 DIGITS -->` after its first one, the SHA-256 of all other lines:
/// `sed '/^<!-- sha256 /d' FILE | sha256sum`.
std::string with_page_sum(std::string_view page);

enum class PageSum {
  right,
  wrong,
  none  ///< a version of the program without checksums wrote the page, or something else did
};

/// Compares a page with its checksum; ends of lines in CR LF change nothing.
PageSum check_page(std::string_view page);

/// A text whose lines end in LF, where its first one ends in CR LF.
std::string without_carriage_returns(std::string_view text);

}  // namespace rubsweep::batch
