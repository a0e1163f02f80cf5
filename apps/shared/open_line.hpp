#pragma once

namespace rubsweep::apps {

/// State of stderr: whether its last line is unfinished and must be ended before a message. May be used in
/// signal handlers.
void set_open_line(bool open);
bool line_is_open();

}  // namespace rubsweep::apps
