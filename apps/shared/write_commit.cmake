# Writes OUTPUT, a header that names the commit of SOURCE, unless OUTPUT already names it. The name is "unknown" where SOURCE
# is not a checkout of its own; "-dirty" follows a commit whose files were changed.
set(commit unknown)
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-prefix OUTPUT_VARIABLE prefix
  RESULT_VARIABLE status ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(status EQUAL 0 AND prefix STREQUAL "")
  execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=* OUTPUT_VARIABLE commit
    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#pragma once

#include <string_view>

namespace rubsweep::apps {

inline constexpr std::string_view commit = "${commit}";

}  // namespace rubsweep::apps
]])
