#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::apps {

/// `text` as a string of JSON with its quotes. Bytes that are no UTF-8, as a file name may have, become
/// U+FFFD.
std::string json_string(std::string_view text);

/// The `texts` as a list of JSON strings.
std::string json_list(const std::vector<std::string>& texts);

}  // namespace rubsweep::apps
