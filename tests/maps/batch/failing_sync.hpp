#pragma once

/// Makes fdatasync of this process fail with EIO during its lifetime, as on a disk that lost data, and counts
/// the calls.
class FailingSync {
 public:
  FailingSync();
  ~FailingSync();
  FailingSync(const FailingSync&) = delete;
  FailingSync& operator=(const FailingSync&) = delete;

  int calls() const;
};
