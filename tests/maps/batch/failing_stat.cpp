#include "maps/batch/failing_stat.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>

namespace {

std::atomic<bool> failing{false};

int fail() {
  errno = EIO;
  return -1;
}

}  // namespace

FailingStat::FailingStat() { failing = true; }
FailingStat::~FailingStat() { failing = false; }

// The linker finds this function before that of the C library, for calls from the C++ library as well.
extern "C" int stat(const char* path, struct stat* facts) noexcept {
  return failing ? fail() : ::fstatat(AT_FDCWD, path, facts, 0);
}

extern "C" int fstat(int descriptor, struct stat* facts) noexcept {
  return failing ? fail() : ::fstatat(descriptor, "", facts, AT_EMPTY_PATH);
}
