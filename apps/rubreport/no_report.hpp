#pragma once

namespace rubsweep::apps {

/// Text after "PROGRAM: interrupted; " if a signal came before the report was written.
inline constexpr const char* no_report = "no report was written, the map is as it was";

}  // namespace rubsweep::apps
