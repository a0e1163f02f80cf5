#pragma once

namespace rubsweep::audit {

/// Parts of the program `audit`, each with the arguments after its name; they return an exit code, and the
/// sources say what they do.
int events(int argc, char** argv);
int proofs(int argc, char** argv);
int wall_starts(int argc, char** argv);

}  // namespace rubsweep::audit
