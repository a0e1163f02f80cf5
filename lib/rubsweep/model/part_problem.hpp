#pragma once

namespace rubsweep::model {

/// Problem of the numbers of one part together, each of which is in its range.
struct PartProblem {
  const char* key = nullptr;      ///< the one to blame
  const char* wrong = nullptr;    ///< finishes a sentence about it
  const char* allowed = nullptr;  ///< finishes "allowed: "
};

}  // namespace rubsweep::model
