#pragma once

#include <string_view>

namespace rubsweep::page {

/// File that the build embedded in the program.
struct Asset {
  std::string_view text;
  std::string_view sha256;  ///< digest of the text, 64 hexadecimal digits
};

/// Parts of the page: the HTML document with placeholders, its style sheet and its script.
extern const Asset document, style, script;

/// Chart library D3 and its licence, from the package that the build found.
extern const Asset library, library_licence;

}  // namespace rubsweep::page
