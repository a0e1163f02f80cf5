#pragma once

/// While it lives, the system cannot tell anything about files: stat and fstat of this process fail with EIO,
/// as on a disk or a network in trouble.
class FailingStat {
 public:
  FailingStat();
  ~FailingStat();
  FailingStat(const FailingStat&) = delete;
  FailingStat& operator=(const FailingStat&) = delete;
};
