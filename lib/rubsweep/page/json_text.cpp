#include "rubsweep/page/json_text.hpp"

#include <boost/json/src.hpp>  // the library's code: here and nowhere else

namespace rubsweep::page {

std::string json_text(const boost::json::value& value) {
  std::string text;
  for (const char c : boost::json::serialize(value)) {
    // Outside strings JSON has no '<'.
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace rubsweep::page
