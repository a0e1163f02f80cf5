#pragma once

namespace rubsweep::response::motion {

/// When a run is long enough and how finely it is looked at.
struct ResponseOptions {
  int max_revolutions = 600;         ///< a run ends here at the latest; at least two windows
  int samples_per_revolution = 128;  ///< even, >= 4 max_order resolves every line that the classes need
  int window_revolutions = 64;       ///< a window of order n is n floor(window_revolutions / n) turns
  bool floquet_proof = true;         ///< stop as soon as a stable periodic orbit is proven
  /// Off: a motion without a period at the end of a run is unsettled, which costs less. Does not stop
  /// `TorusWatch`, which goes by `floquet_proof`.
  bool exponent = true;
  int max_order = 12;  ///< largest n of a 1/n subharmonic looked for; at most half a window
};

}  // namespace rubsweep::response::motion
