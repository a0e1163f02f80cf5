// Preloaded library that records what a program does to the files below the directory IO_DIRECTORY: one line
// per successful call in the file IO_RECORD. From this tests/apps/power_loss.py reconstructs what a disk
// contains after a loss of power. Each reading of the clock advances by six seconds, so that actions due
// after some seconds happen.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace {

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

struct Opened {
  int number = 0;    ///< number of the open call
  std::string path;  ///< absolute path
  bool directory = false;
  bool append = false;
};

struct Recorder {
  std::mutex mutex;
  std::map<int, Opened> files;  ///< open files by descriptor
  int opened = 0;
  int output = -1;
  std::string below;

  Recorder() {
    const char *directory = std::getenv("IO_DIRECTORY"), *record = std::getenv("IO_RECORD");
    if (directory == nullptr || record == nullptr) return;
    below = std::string(directory) + "/";
    output =
        real<int(const char*, int, ...)>("open")(record, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  }

  bool records(const std::string& path) const {
    return output >= 0 && (path.starts_with(below) || path + "/" == below);
  }

  void line(const std::string& text) const {
    const std::string whole = text + "\n";
    (void)!real<ssize_t(int, const void*, std::size_t)>("write")(output, whole.data(), whole.size());
  }
};

/// Never destroyed, because calls may come until the process ends.
Recorder& recorder() {
  static Recorder& only = *new Recorder;
  return only;
}

std::string absolute(const char* path) {
  if (path[0] == '/') return path;
  char* here = ::getcwd(nullptr, 0);
  std::string whole = std::string(here) + "/" + path;
  std::free(here);
  return whole;
}

bool exists(const std::string& path) {
  struct stat facts {};
  return ::lstat(path.c_str(), &facts) == 0;
}

std::string hexadecimal(const void* data, std::size_t length) {
  std::string text;
  for (const char c : std::string_view(static_cast<const char*>(data), length)) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    text += digits;
  }
  return text;
}

int open_recorded(const char* name, const char* path, int flags, mode_t mode) {
  Recorder& all = recorder();
  const std::string whole = absolute(path);
  const std::lock_guard lock(all.mutex);
  const bool before = exists(whole);
  const int descriptor = real<int(const char*, int, ...)>(name)(path, flags, mode);
  if (descriptor < 0 || !all.records(whole)) return descriptor;
  struct stat facts {};
  ::fstat(descriptor, &facts);
  Opened opened{++all.opened, whole, S_ISDIR(facts.st_mode), (flags & O_APPEND) != 0};
  const bool writes = (flags & O_ACCMODE) != O_RDONLY;
  if (!opened.directory && writes) {
    all.line("open " + std::to_string(opened.number) + (before ? " old" : " new") +
             ((flags & O_TRUNC) != 0 ? " empty " : " whole ") + whole);
  }
  all.files[descriptor] = opened;
  return descriptor;
}

template <class Call>
auto recorded(int descriptor, const Call& call, const auto& text) {
  Recorder& all = recorder();
  const std::lock_guard lock(all.mutex);
  const auto result = call();
  const auto file = all.files.find(descriptor);
  if (result >= 0 && file != all.files.end()) all.line(text(file->second, result));
  return result;
}

int sync_recorded(const char* name, int descriptor) {
  return recorded(
      descriptor, [&] { return real<int(int)>(name)(descriptor); },
      [](const Opened& file, int) {
        return file.directory ? "syncdir " + file.path : "sync " + std::to_string(file.number);
      });
}

int change_recorded(const char* name, const char* path, const char* word) {
  Recorder& all = recorder();
  const std::lock_guard lock(all.mutex);
  const int result = real<int(const char*)>(name)(path);
  if (result == 0 && all.records(absolute(path))) all.line(word + (" " + absolute(path)));
  return result;
}

ssize_t pwrite_recorded(const char* name, int descriptor, const void* data, std::size_t length,
                        off_t offset) {
  return recorded(
      descriptor,
      [&] {
        return real<ssize_t(int, const void*, std::size_t, off_t)>(name)(descriptor, data, length, offset);
      },
      [&](const Opened& file, ssize_t written) {
        return "write " + std::to_string(file.number) + " " + std::to_string(offset) + " " +
               hexadecimal(data, static_cast<std::size_t>(written));
      });
}

int truncate_recorded(const char* name, int descriptor, off_t length) {
  return recorded(
      descriptor, [&] { return real<int(int, off_t)>(name)(descriptor, length); },
      [&](const Opened& file, int) {
        return "truncate " + std::to_string(file.number) + " " + std::to_string(length);
      });
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_recorded("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_recorded("open64", path, flags, mode);
}

int close(int descriptor) {
  {
    const std::lock_guard lock(recorder().mutex);
    recorder().files.erase(descriptor);
  }
  return real<int(int)>("close")(descriptor);
}

ssize_t write(int descriptor, const void* data, std::size_t length) {
  return recorded(
      descriptor,
      [&] { return real<ssize_t(int, const void*, std::size_t)>("write")(descriptor, data, length); },
      [&](const Opened& file, ssize_t written) {
        const off_t end = ::lseek(descriptor, 0, SEEK_CUR);
        return "write " + std::to_string(file.number) + " " + std::to_string(end - written) + " " +
               hexadecimal(data, static_cast<std::size_t>(written));
      });
}

ssize_t pwrite(int descriptor, const void* data, std::size_t length, off_t offset) {
  return pwrite_recorded("pwrite", descriptor, data, length, offset);
}

ssize_t pwrite64(int descriptor, const void* data, std::size_t length, off64_t offset) {
  return pwrite_recorded("pwrite64", descriptor, data, length, offset);
}

int ftruncate(int descriptor, off_t length) noexcept {
  return truncate_recorded("ftruncate", descriptor, length);
}

int ftruncate64(int descriptor, off64_t length) noexcept {
  return truncate_recorded("ftruncate64", descriptor, length);
}

int fsync(int descriptor) { return sync_recorded("fsync", descriptor); }

int fdatasync(int descriptor) { return sync_recorded("fdatasync", descriptor); }

int unlink(const char* path) noexcept { return change_recorded("unlink", path, "remove"); }

int remove(const char* path) noexcept { return change_recorded("remove", path, "remove"); }

int mkdir(const char* path, mode_t mode) noexcept {
  Recorder& all = recorder();
  const std::lock_guard lock(all.mutex);
  const int result = real<int(const char*, mode_t)>("mkdir")(path, mode);
  if (result == 0 && all.records(absolute(path))) all.line("mkdir " + absolute(path));
  return result;
}

int rename(const char* from, const char* to) noexcept {
  Recorder& all = recorder();
  const std::lock_guard lock(all.mutex);
  const int result = real<int(const char*, const char*)>("rename")(from, to);
  if (result == 0 && all.records(absolute(to))) all.line("rename " + absolute(from) + "\t" + absolute(to));
  return result;
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static std::mutex mutex;
  static long looks = 0;
  const int result = real<int(clockid_t, timespec*)>("clock_gettime")(clock, time);
  if (result != 0 || clock != CLOCK_MONOTONIC) return result;
  const std::lock_guard lock(mutex);
  time->tv_sec += 6 * ++looks;
  return result;
}

}  // extern "C"
