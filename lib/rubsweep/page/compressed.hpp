#pragma once

#include <string>
#include <string_view>

namespace rubsweep::page {

/// `bytes` in base64 (RFC 4648) with its padding.
std::string base64(std::string_view bytes);

/// `bytes` compressed in the zlib format, in base64: what a browser reads back by atob and
/// DecompressionStream("deflate"). Equal bytes give equal texts. Throws std::bad_alloc.
std::string compressed(std::string_view bytes);

}  // namespace rubsweep::page
