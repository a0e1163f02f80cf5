#include "rubsweep/maps/batch/journal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <charconv>
#include <optional>
#include <utility>

#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

constexpr std::string_view first_line = "rubsweep journal 1";
constexpr std::string_view last_header_line = "records";
constexpr std::size_t checksum_length = 9;  // eight hexadecimal digits and a blank

std::string with_checksum(std::string_view content) {
  boost::crc_32_type checksum;
  checksum.process_bytes(content.data(), content.size());
  return fmt::format("{:08x} {}", checksum.checksum(), content);
}

std::optional<std::string_view> content_of(std::string_view line) {
  if (line.size() < checksum_length) return std::nullopt;
  const std::string_view content = line.substr(checksum_length);
  if (with_checksum(content) != line) return std::nullopt;
  return content;
}

std::optional<std::size_t> read_size(std::string_view text) {
  std::size_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Reads the lines of a file of any size, one at a time.
class LineReader {
 public:
  explicit LineReader(const std::filesystem::path& path) : lines_(path) {}

  /// Takes the next line without its line end; false at the end of the file. A last line without a line end
  /// was not written completely and is ignored.
  bool next(std::string_view& line, std::uint64_t& offset) {
    if (std::exchange(again_, false)) {
      line = line_;
      offset = offset_;
      return true;
    }
    const std::string_view read = lines_.next();
    if (!read.ends_with('\n')) return false;
    offset = offset_ = position_;
    position_ += read.size();
    line = line_ = read.substr(0, read.size() - 1);
    return true;
  }

  /// The next call of `next` returns the last line again.
  void again() { again_ = true; }

 private:
  InputLines lines_;
  std::uint64_t position_ = 0;
  std::string_view line_;  ///< line returned last
  std::uint64_t offset_ = 0;
  bool again_ = false;
};

std::string header_text(const JournalHeader& header) {
  std::string text;
  const auto add = [&](std::string_view line) { text += with_checksum(line) + '\n'; };
  add(first_line);
  add(header.study_digest);
  add(header.program_digest);
  add(std::to_string(header.cells));
  std::string_view rest = header.study;
  while (!rest.empty()) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    add(fmt::format(":{}", rest.substr(0, length)));
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  add(last_header_line);
  return text;
}

/// Reads the header and verifies its lines first, since these lines decide whether the records can be
/// trusted.
JournalHeader read_header(LineReader& lines, const std::filesystem::path& path) {
  JournalHeader header;
  int number = 0, first_damaged = 0;
  std::string_view line;
  std::uint64_t offset = 0;
  const auto refuse = [&] {
    throw DamagedJournal(fmt::format("{}:{}: not a journal of this program, or a damaged one", path.string(),
                                     first_damaged > 0 ? first_damaged : number));
  };
  // Empty for a damaged line, since no line of a header is empty.
  const auto next = [&] {
    ++number;
    if (!lines.next(line, offset)) refuse();
    std::string content(content_of(line).value_or(""));
    if (content.empty() && header.damaged_lines++ == 0) first_damaged = number;
    return content;
  };
  if (const std::string begin = next(); !begin.empty() && begin != first_line) refuse();
  header.study_digest = next();
  const bool study_is_needed = header.study_digest.empty();
  header.program_digest = next();
  if (header.program_digest.empty()) refuse();
  header.cells = read_size(next()).value_or(0);
  if (header.cells == 0) refuse();
  for (std::string content = next(); content != last_header_line; content = next()) {
    if (content.starts_with(':')) {
      header.study.append(content, 1) += '\n';
    } else if (!content.empty()) {  // the line before this record is damaged
      lines.again();
      break;
    } else if (study_is_needed) {
      refuse();
    }
  }
  return header;
}

constexpr unsigned offset_bits = 48;
constexpr std::uint64_t offset_mask = (std::uint64_t{1} << offset_bits) - 1;
constexpr std::size_t most_files = 0xffff;  // the last index is reserved for `nowhere`

}  // namespace

bool same_results(const JournalHeader& a, const JournalHeader& b) {
  const bool same_study = a.study_digest.empty() ? a.study == b.study : a.study_digest == b.study_digest;
  return same_study && a.program_digest == b.program_digest && a.cells == b.cells;
}

JournalHeader read_journal_header(const std::filesystem::path& path) {
  LineReader lines(path);
  return read_header(lines, path);
}

std::size_t read_journal(const std::filesystem::path& path,
                         const std::function<void(const JournalRecord&)>& on_record) {
  LineReader lines(path);
  const JournalHeader header = read_header(lines, path);
  std::size_t damaged = 0;
  std::string_view line;
  std::uint64_t offset = 0;
  while (lines.next(line, offset)) {
    const auto content = content_of(line);
    const std::size_t blank = content ? content->find(' ') : std::string_view::npos;
    const auto cell = blank == std::string_view::npos ? std::nullopt : read_size(content->substr(0, blank));
    if (!cell || *cell >= header.cells) {
      ++damaged;
    } else {
      on_record({*cell, content->substr(blank + 1), offset + checksum_length + blank + 1});
    }
  }
  return damaged;
}

Journal::Journal(const std::filesystem::path& path, const JournalHeader& header)
    : log_([&] {
        refuse_link("write", path);
        std::error_code unknown;
        const bool there = std::filesystem::exists(path, unknown);
        // A file that cannot be examined may still exist. Writing a header over it would destroy its records.
        if (unknown) throw_io_error("look at", path, unknown.value());
        if (!there) write_whole_file(path, header_text(header));
        return path;
      }()) {}

void Journal::append(std::size_t cell, std::string_view text) {
  if (text.find('\n') != std::string_view::npos) throw SolverError("a journal keeps single lines");
  log_.append(with_checksum(fmt::format("{} {}", cell, text)));
}

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
