#pragma once

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::response::motion {

/// Length of a run and resolution of its measures.
struct ResponseOptions {
  int max_revolutions = 600;         ///< longest run; at least two windows
  int samples_per_revolution = 128;  ///< even, >= 4 max_order to resolve all lines that the classes need
  int window_revolutions = 64;       ///< a window for order n has n floor(window_revolutions / n) turns
  bool floquet_proof = true;         ///< a run ends as soon as a stable periodic orbit is proven
  /// False: a motion without a period at the end of a run is unsettled, which saves time. This does not
  /// affect `TorusWatch`, which depends on `floquet_proof`.
  bool exponent = true;
  int max_order = 12;  ///< largest n of a 1/n subharmonic that is sought; at most half a window

  static void visit_fields(auto& self, auto&& visit) {
    using model::IntegerRange, model::key;
    visit("max_revolutions", self.max_revolutions,
          key(IntegerRange{2, 10'000'000}, "revolutions at which a run ends at the latest"));
    // The largest window holds 4096 x 4096 samples, 256 MiB for each thread.
    visit("samples_per_revolution", self.samples_per_revolution,
          key(IntegerRange{4, 4096, true}, "samples of the last two windows"));
    visit("window_revolutions", self.window_revolutions, key(IntegerRange{2, 4096}, "length of a window"));
    visit("max_order", self.max_order,
          key(IntegerRange{1, 1024}, "largest n of a 1/n motion that is looked for"));
    visit("floquet_proof", self.floquet_proof,
          key(off_or_on, "whether a run ends as soon as a stable orbit is proven"));
  }
};

}  // namespace rubsweep::response::motion
