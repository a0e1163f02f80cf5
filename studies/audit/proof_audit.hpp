#pragma once

#include <optional>
#include <string>

#include "audit/random_machine.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::audit {

/// Result for a cell whose motion was proven or observed to settle on a periodic orbit.
struct ProofAudit {
  bool simulated = false;  ///< the kick decided the motion, and the run did not fail
  std::optional<response::motion::Proof> proof;
  bool followed = false;   ///< its proof concerns an orbit, and the run continued
  bool confirmed = false;  ///< the run reached the motion that was proven
  bool undecided = false;  ///< neither confirmed nor refuted within the allowed turns
  long turns = 0;          ///< number of turns after the proof
  std::string finding;     ///< motion that it reached instead
};

/// Settles a cell. If its class is based on `floquet` or `floquet_observed`, the run continues from there
/// without proofs. It is confirmed when its section returns after exactly the proven number of turns (within
/// 1e-9 clearances for closed forms, else 1e-6), with contact. A motion that is periodic only in the rotating
/// frame is confirmed by its peak displacement over 64 turns.
ProofAudit audit_proof(const RandomCell& cell);

/// The simplest machine, with the fewest parts and the shortest numbers, that still shows the finding.
RandomCell minimised(const RandomCell& cell);

}  // namespace rubsweep::audit
