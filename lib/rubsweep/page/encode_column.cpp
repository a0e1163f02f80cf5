#include "rubsweep/page/encode_column.hpp"

#include <cstdint>
#include <unordered_map>

#include "rubsweep/page/byte_writer.hpp"
#include "rubsweep/page/compressed.hpp"

namespace rubsweep::page {

EncodedColumn encode_column(const MapColumn& column) {
  EncodedColumn encoded;
  std::string records, planes;
  if (!column.numbers.empty()) {
    for (const double number : column.numbers) append(records, number);
    append_planes(planes, records, 8);
  } else {
    std::unordered_map<std::string, std::uint32_t> places;
    for (const std::string& word : column.words) {
      const auto [found, is_new] = places.try_emplace(word, static_cast<std::uint32_t>(places.size()));
      if (is_new) encoded.words.push_back(word);
      append(records, found->second);
    }
    append_planes(planes, records, 4);
  }
  encoded.data = compressed(planes);
  return encoded;
}

}  // namespace rubsweep::page
