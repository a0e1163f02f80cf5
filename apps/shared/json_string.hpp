#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::apps {

/// `text` as a JSON string with its quotes. Invalid UTF-8, as in a file name, becomes U+FFFD.
std::string json_string(std::string_view text);

/// The `texts` as a list of JSON strings.
std::string json_list(const std::vector<std::string>& texts);

}  // namespace rubsweep::apps
