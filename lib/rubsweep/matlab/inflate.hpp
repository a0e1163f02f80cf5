#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rubsweep::matlab {

/// The first `count` bytes of what zlib packed, or fewer where it holds fewer. Throws FileError where it is
/// damaged so far.
std::string inflate_begin(std::string_view packed, std::size_t count);

/// All bytes of what zlib packed, to its end and with its checksum. Throws FileError where these are wrong,
/// or it holds more than `most`.
std::string inflate_all(std::string_view packed, std::size_t most);

}  // namespace rubsweep::matlab
