#pragma once

/// Makes stat and fstat of this process fail with EIO during its lifetime, as with a faulty disk or network.
class FailingStat {
 public:
  FailingStat();
  ~FailingStat();
  FailingStat(const FailingStat&) = delete;
  FailingStat& operator=(const FailingStat&) = delete;
};
