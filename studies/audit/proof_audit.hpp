#pragma once

#include <optional>
#include <string>

#include "audit/random_machine.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::audit {

/// Fate of a cell whose motion was proven or observed to settle on a periodic orbit.
struct ProofAudit {
  bool simulated = false;  ///< the kick decided, the run did not fail
  std::optional<response::motion::Proof> proof;
  bool followed = false;   ///< its proof is about an orbit, and the run went on
  bool confirmed = false;  ///< the run went to the motion that the proof names
  bool undecided = false;  ///< neither confirmed nor left within the turns given
  long turns = 0;          ///< that the run took after the proof
  std::string finding;     ///< where it went instead
};

/// Settles a cell, and where its class rests on `floquet` or `floquet_observed` runs the cell again without
/// any proof, on and on from where it was proven, until its section returns after the proven number of
/// turns (within 1e-9 clearances by closed forms, 1e-6 otherwise), after no fewer, and with contact. A
/// motion that is periodic only in the rotating frame is confirmed by its peak displacement over 64 turns.
ProofAudit audit_proof(const RandomCell& cell);

/// A machine with as few parts and as short numbers as still give a finding.
RandomCell minimised(const RandomCell& cell);

}  // namespace rubsweep::audit
