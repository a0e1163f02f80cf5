#pragma once

namespace rubsweep::branch::journal {

/// The map_digest and the compiled libraries that families of orbits depend on besides, as one SHA-1.
extern const char* const family_digest;

}  // namespace rubsweep::branch::journal
