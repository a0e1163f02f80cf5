#pragma once

namespace rubsweep::apps {

/// Whether an unfinished line stands on stderr, which has to end before a message: for signal handlers, too.
void set_open_line(bool open);
bool line_is_open();

}  // namespace rubsweep::apps
