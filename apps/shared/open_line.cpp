#include "shared/open_line.hpp"

#include <atomic>

namespace rubsweep::apps {
namespace {

std::atomic<bool> line{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void set_open_line(bool open) { line = open; }

bool line_is_open() { return line; }

}  // namespace rubsweep::apps
