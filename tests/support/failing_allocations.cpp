// Preloaded library (LD_PRELOAD) that makes one allocation of a program fail: number FAIL_ALLOCATION, counted
// from 1; with FAIL_ALL every later one fails, too. COUNT_ALLOCATIONS=FILE writes the number of allocations
// there at the end. Allocations of libraries before the program begins are not counted, because libstdc++
// cannot throw without its emergency pool.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

std::atomic<long> allocations{0};
std::atomic<long> failing{-1};  ///< -1: not yet read
std::atomic<bool> all_after{false};
std::atomic<bool> begun{false};

/// Whether this allocation fails; std::getenv does not allocate.
bool fails() {
  if (!begun) return false;
  if (failing < 0) {
    const char* number = std::getenv("FAIL_ALLOCATION");
    all_after = std::getenv("FAIL_ALL") != nullptr;
    failing = number == nullptr ? 0 : std::atol(number);
  }
  const long number = ++allocations;
  if (failing == 0 || number < failing || (number > failing && !all_after)) return false;
  errno = ENOMEM;
  return true;
}

/// Constructed after all libraries of the program, and before the program's own objects.
struct FromBeginningToEnd {
  FromBeginningToEnd() { begun = true; }
  ~FromBeginningToEnd() {
    const char* file = std::getenv("COUNT_ALLOCATIONS");
    if (file == nullptr) return;
    const int descriptor = ::open(file, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dprintf(descriptor, "%ld\n", allocations.load());
    ::close(descriptor);
  }
} from_beginning_to_end;

}  // namespace

extern "C" {
void* malloc(std::size_t bytes) { return fails() ? nullptr : __libc_malloc(bytes); }
void* calloc(std::size_t count, std::size_t bytes) { return fails() ? nullptr : __libc_calloc(count, bytes); }
void* realloc(void* old, std::size_t bytes) { return fails() ? nullptr : __libc_realloc(old, bytes); }
void* memalign(std::size_t alignment, std::size_t bytes) {
  return fails() ? nullptr : __libc_memalign(alignment, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return fails() ? nullptr : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
  if (fails()) return ENOMEM;
  *block = __libc_memalign(alignment, bytes);
  return *block == nullptr ? ENOMEM : 0;
}
}
