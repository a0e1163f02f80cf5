#pragma once

/// While it lives, fdatasync of this process fails with EIO, as on a disk that has lost what it was given, and
/// calls are counted.
class FailingSync {
 public:
  FailingSync();
  ~FailingSync();
  FailingSync(const FailingSync&) = delete;
  FailingSync& operator=(const FailingSync&) = delete;

  int calls() const;
};
