#pragma once

namespace rubsweep::branch::journal {

/// SHA-1 of map_digest and of the other compiled libraries on which families of orbits depend.
extern const char* const family_digest;

}  // namespace rubsweep::branch::journal
