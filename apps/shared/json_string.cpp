#include "shared/json_string.hpp"

#include <nlohmann/json.hpp>

namespace rubsweep::apps {

std::string json_string(std::string_view text) {
  using nlohmann::json;
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string json_list(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) result.append(result.empty() ? "" : ",").append(json_string(text));
  return "[" + result + "]";
}

}  // namespace rubsweep::apps
