#pragma once

#include <atomic>

namespace rubsweep::apps {

/// From now on SIGINT and SIGTERM only set the returned flag, so that running cells can finish and be kept.
const std::atomic<bool>& catch_interrupts();

/// The signal that set the flag, 0 if none did.
int caught_signal();

}  // namespace rubsweep::apps
