#pragma once

#include <string_view>

namespace rubsweep::page {

/// A file that the build put into the program.
struct Asset {
  std::string_view text;
  std::string_view sha256;  ///< digest of the text, 64 hexadecimal digits
};

/// The page's document with its places to fill in, its style sheet and its script.
extern const Asset document, style, script;

/// The chart library D3 and its licence, from the package that the build found.
extern const Asset library, library_licence;

}  // namespace rubsweep::page
