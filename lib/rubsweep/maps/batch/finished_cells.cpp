#include "rubsweep/maps/batch/finished_cells.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/input_file.hpp"
#include "rubsweep/maps/batch/journal.hpp"

namespace rubsweep::batch {
namespace {

constexpr unsigned offset_bits = 48;
constexpr std::uint64_t offset_mask = (std::uint64_t{1} << offset_bits) - 1;
constexpr std::size_t most_files = 0xffff;  // the last index would be `nowhere`

}  // namespace

std::size_t FinishedCells::add(const std::filesystem::path& journal) {
  if (files_.size() == most_files) throw IoError("too many journals, allowed: 65535");
  const std::uint64_t file = static_cast<std::uint64_t>(files_.size()) << offset_bits;
  files_.push_back({journal, open_input(journal)});
  return read_journal(journal, [&](const JournalRecord& record) {
    std::uint64_t& place = places_.at(record.cell);
    if (place != nowhere) return;
    place = file | record.offset;
    ++count_;
  });
}

std::vector<std::size_t> FinishedCells::missing() const {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < places_.size(); ++cell) {
    if (!contains(cell)) cells.push_back(cell);
  }
  return cells;
}

std::string FinishedCells::text(std::size_t cell) const {
  const std::uint64_t place = places_.at(cell);
  const File& file = files_.at(place >> offset_bits);
  std::string text;
  std::array<char, 1024> piece;
  while (true) {
    const auto offset = static_cast<off_t>((place & offset_mask) + text.size());
    const ssize_t length = ::pread(file.descriptor.get(), piece.data(), piece.size(), offset);
    if (length <= 0) throw_io_error("read", file.path, length < 0 ? errno : EIO);
    const std::string_view read(piece.data(), static_cast<std::size_t>(length));
    const std::size_t end = read.find('\n');
    text += read.substr(0, end);
    if (end != std::string_view::npos) return text;
  }
}

}  // namespace rubsweep::batch
