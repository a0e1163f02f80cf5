// Loaded before a program (LD_PRELOAD), lets one of its allocations fail, and with FAIL_ALL every later one
// as well: FAIL_ALLOCATION is its number from 1. With COUNT_ALLOCATIONS=FILE, how many there were is written
// there at the end. What libraries allocate before the program begins is not counted: without room for its
// emergency pool libstdc++ cannot throw.
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

/// std::getenv allocates nothing.
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

/// The loader makes it after all libraries that the program names, and before the program's own.
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
