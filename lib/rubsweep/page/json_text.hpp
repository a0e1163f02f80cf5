#pragma once

#include <boost/json/value.hpp>
#include <string>

namespace rubsweep::page {

/// `value` as JSON that may stand inside an HTML script element: no character of it opens a tag.
std::string json_text(const boost::json::value& value);

}  // namespace rubsweep::page
