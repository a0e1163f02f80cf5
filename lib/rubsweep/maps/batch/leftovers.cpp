#include "rubsweep/maps/batch/leftovers.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <string>
#include <system_error>

#include "rubsweep/maps/batch/descriptor.hpp"

namespace rubsweep::batch {
namespace {

constexpr std::string_view mark = ".tmp-";

/// Whoever writes a temporary holds its lock until it has its name (see WholeFile).
void remove_where_nobody_writes(const std::filesystem::path& file) {
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (opened.get() < 0 || ::flock(opened.get(), LOCK_EX | LOCK_NB) != 0) return;
  if (is_file_at(opened.get(), file)) ::unlink(file.c_str());
}

}  // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  std::filesystem::path temporary = path;
  return temporary += fmt::format("{}{}-{}", mark, host.data(), ::getpid());
}

bool is_temporary(std::string_view name) {
  const std::size_t place = name.rfind(mark), process = name.rfind('-') + 1;
  return place != std::string_view::npos && process > place + mark.size() && process < name.size() &&
         name.find_first_not_of("0123456789", process) == std::string_view::npos;
}

void remove_leftovers(const std::filesystem::path& directory,
                      const std::function<bool(std::string_view name)>& is_ours) {
  std::error_code none;  // a directory that cannot be read keeps what is in it
  for (std::filesystem::directory_iterator entry(directory.empty() ? "." : directory, none), end;
       !none && entry != end; entry.increment(none)) {
    const std::string name = entry->path().filename();
    if (is_temporary(name) && is_ours(std::string_view(name).substr(0, name.rfind(mark))))
      remove_where_nobody_writes(entry->path());
  }
}

}  // namespace rubsweep::batch
