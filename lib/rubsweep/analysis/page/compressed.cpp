#include "rubsweep/analysis/page/compressed.hpp"

#include <zlib.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <new>

namespace rubsweep::page {

std::string base64(std::string_view bytes) {
  namespace it = boost::archive::iterators;
  using Text = it::base64_from_binary<it::transform_width<std::string::const_iterator, 6, 8>>;
  // The iterators read whole groups of three bytes, and would therefore read beyond the end.
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  std::string padded(bytes);
  padded.append(missing, '\0');
  std::string text(Text(padded.cbegin()), Text(padded.cend()));
  text.replace(text.size() - missing, missing, missing, '=');
  return text;
}

std::string compressed(std::string_view bytes) {
  uLongf size = ::compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int code = ::compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                               Z_BEST_COMPRESSION);
  // the buffer is large enough, so that the only possible error is lack of memory
  if (code != Z_OK) throw std::bad_alloc();
  result.resize(size);
  return base64(result);
}

}  // namespace rubsweep::page
