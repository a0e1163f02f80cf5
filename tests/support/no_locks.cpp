// Preloaded library (LD_PRELOAD) that makes flock(2) fail on every file system; with NO_RECORD_LOCKS the
// locks of fcntl(2) fail as well.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>

namespace {

using Fcntl = int (*)(int, int, ...);

int answer(const char* name, int descriptor, int command, void* argument) {
  const bool locks = command == F_OFD_SETLK || command == F_OFD_SETLKW;
  if (locks && std::getenv("NO_RECORD_LOCKS") != nullptr) {
    errno = ENOLCK;
    return -1;
  }
  return reinterpret_cast<Fcntl>(::dlsym(RTLD_NEXT, name))(descriptor, command, argument);
}

}  // namespace

extern "C" {
int flock(int, int) noexcept {
  errno = ENOLCK;
  return -1;
}
int fcntl(int descriptor, int command, ...) {
  va_list rest;
  va_start(rest, command);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  return answer("fcntl", descriptor, command, argument);
}
int fcntl64(int descriptor, int command, ...) {
  va_list rest;
  va_start(rest, command);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  return answer("fcntl64", descriptor, command, argument);
}
}
