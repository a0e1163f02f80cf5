#pragma once

namespace rubsweep::audit {

/// Parts of the program `audit`. Each gets the arguments after its name and returns an exit code; the sources
/// describe them.
int events(int argc, char** argv);
int proofs(int argc, char** argv);
int wall_starts(int argc, char** argv);

}  // namespace rubsweep::audit
