#include "rubsweep/maps/batch/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <regex>
#include <thread>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

class FileLockCases : public testing::Test {
 protected:
  void expect_taken(LockMode mode) {
    EXPECT_TRUE(std::regex_match(message_of<LockedError>([&] { FileLock(path_, mode, "second"); }),
                                 std::regex(".*map.lock is held by first, process [0-9]+ on .+ since "
                                            "[0-9]{4}-[0-9]{2}-[0-9]{2} [0-9:]{8} UTC")));
  }

  const TemporaryDirectory directory_;
  const std::filesystem::path path_ = directory_.path() / "map.lock";
};

/// A lock must overwrite neither the target of a link with its name nor a foreign file with its name.
TEST_F(FileLockCases, NeverWritesOverWhatIsNotOurs) {
  const auto precious = directory_.path() / "thesis.txt";
  write_whole_file(precious, "precious\n");
  std::filesystem::create_hard_link(precious, path_);
  for (const LockMode mode : {LockMode::exclusive, LockMode::shared})
    EXPECT_NE(message_of<IoError>([&] { FileLock(path_, mode, "first"); }).find("another name"),
              std::string::npos);
  EXPECT_EQ(read_whole_file(precious), "precious\n");
  std::filesystem::remove(path_);
  for (const char* text :
       {"precious\n", "rubsweep, process 1 on host\n", "a, process 1 on b UTC\nmore UTC\n"}) {
    write_whole_file(path_, text);
    EXPECT_NE(message_of<IoError>([&] {
                FileLock(path_, LockMode::exclusive, "first");
              }).find("no program of ours"),
              std::string::npos);
    EXPECT_EQ(read_whole_file(path_), text);
  }
  write_whole_file(path_, "");  // left by a process that was killed before it wrote its line
  const FileLock lock(path_, LockMode::exclusive, "first");
}

TEST_F(FileLockCases, IsHeldUntilTheEndAndThenGone) {
  {
    const FileLock lock(path_, LockMode::exclusive, "first");
    expect_taken(LockMode::exclusive);
    expect_taken(LockMode::shared);
    EXPECT_TRUE(lock_holder(path_).has_value());
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  const FileLock again(path_, LockMode::exclusive, "first");
}

TEST_F(FileLockCases, CanBeShared) {
  std::optional<FileLock> one(std::in_place, path_, LockMode::shared, "first");
  {
    const FileLock two(path_, LockMode::shared, "first");
    expect_taken(LockMode::exclusive);
  }
  ASSERT_TRUE(std::filesystem::exists(path_)) << "the other one still holds it";
  expect_taken(LockMode::exclusive);
  one.reset();
  EXPECT_FALSE(std::filesystem::exists(path_));
}

/// The last process to leave takes an exclusive lock to remove the file; others that come meanwhile must not
/// be refused.
TEST_F(FileLockCases, SharedByThoseWhoComeAndGoIsNeverRefused) {
  const auto come_and_go = [&] {
    for (int i = 0; i < 3000; ++i) const FileLock lock(path_, LockMode::shared, "first");
  };
  const std::jthread other([&] { EXPECT_NO_THROW(come_and_go()); });
  EXPECT_NO_THROW(come_and_go());
}

TEST_F(FileLockCases, OfAProcessThatWasKilledMeansNothing) {
  const pid_t child = ::fork();
  if (child == 0) {
    const FileLock lock(path_, LockMode::exclusive, "killed");
    std::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_NE(read_whole_file(path_).find("killed, process " + std::to_string(child)), std::string::npos);
  EXPECT_EQ(lock_holder(path_), std::nullopt);
  const FileLock lock(path_, LockMode::exclusive, "first");
  expect_taken(LockMode::exclusive);
}

TEST_F(FileLockCases, FreedAtAnyMomentIsEitherHeldOrNot) {
  const std::jthread holder([&](const std::stop_token& end) {
    while (!end.stop_requested()) {
      try {
        const FileLock lock(path_, LockMode::exclusive, "holder");
      } catch (const LockedError&) {
      }
    }
  });
  // An IoError in either process ends the test.
  for (int i = 0; i < 1000; ++i) {
    try {
      const FileLock lock(path_, LockMode::exclusive, "other");
    } catch (const LockedError&) {
    }
    lock_holder(path_);
  }
}

TEST_F(FileLockCases, CanBeWaitedFor) {
  std::optional<FileLock> first(std::in_place, path_, LockMode::exclusive, "first");
  std::atomic<bool> freed = false;
  const std::jthread other([&] {
    const FileLock lock(path_, LockMode::exclusive, "second", Patience::wait);
    EXPECT_TRUE(freed);
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  freed = true;
  first.reset();
}

TEST_F(FileLockCases, OfAnotherDirectoryUnderTheSameNameIsLeftAlone) {
  const auto place = directory_.path() / "map", path = place / "map.lock";
  std::filesystem::create_directory(place);
  std::optional<FileLock> first(std::in_place, path, LockMode::exclusive, "first");
  std::filesystem::remove_all(place);
  std::filesystem::create_directory(place);
  const FileLock second(path, LockMode::exclusive, "second");
  first.reset();
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_TRUE(lock_holder(path).has_value());
}

/// Gives up root rights, if this test has them.
class OrdinaryUser {
 public:
  OrdinaryUser() { EXPECT_EQ(root_ ? ::seteuid(65534) : 0, 0); }
  ~OrdinaryUser() { EXPECT_EQ(root_ ? ::seteuid(0) : 0, 0); }

 private:
  const bool root_ = ::geteuid() == 0;
};

TEST_F(FileLockCases, OfADeadOwnerMeansNothingEvenWhereItCannotBeWritten) {
  for (const bool directory_is_shared : {true, false}) {
    std::filesystem::permissions(directory_.path(),
                                 std::filesystem::perms{directory_is_shared ? 0777U : 0755U});
    write_whole_file(path_, "somebody who is dead\n");
    std::filesystem::permissions(path_, std::filesystem::perms{0444});
    {
      const OrdinaryUser user;
      const FileLock lock(path_, LockMode::exclusive, "first");
      if (directory_is_shared) expect_taken(LockMode::exclusive);
      EXPECT_TRUE(lock_holder(path_).has_value());
    }
    std::filesystem::remove(path_);
  }
}

TEST_F(FileLockCases, ThatCannotBeIsAnError) {
  EXPECT_EQ(message_of<IoError>([] { FileLock("/nowhere/map.lock", LockMode::exclusive, "first"); }),
            "cannot lock /nowhere/map.lock: No such file or directory");
}

}  // namespace
}  // namespace rubsweep::batch
