#pragma once

#include <string>
#include <string_view>

namespace rubsweep::table {

/// Text of a file in UTF-8 without its byte order mark: UTF-8, UTF-16 with a mark, or Latin-1 where it is no
/// UTF-8, as spreadsheets of Windows write the sign for micro. Throws Fault for bytes that are no text.
std::string utf8_of(std::string_view bytes);

}  // namespace rubsweep::table
