#include "maps/batch/failing_sync.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

namespace {

std::atomic<bool> failing{false};
std::atomic<int> count{0};

}  // namespace

FailingSync::FailingSync() {
  count = 0;
  failing = true;
}
FailingSync::~FailingSync() { failing = false; }

int FailingSync::calls() const { return count; }

// The linker finds this function before that of the C library.
extern "C" int fdatasync(int descriptor) {
  if (!failing) return static_cast<int>(::syscall(SYS_fdatasync, descriptor));
  ++count;
  errno = EIO;
  return -1;
}
