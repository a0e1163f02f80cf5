#include "shared/written_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/sha256.hpp"

namespace rubsweep::apps {

namespace fs = std::filesystem;

std::string begin_of(const fs::path& file) {
  constexpr std::size_t enough = 4096;
  const batch::Input input = batch::find_input(file);
  std::string begin;
  if (input.problem.empty()) batch::read_bytes(input.descriptor.get(), enough, begin);
  return begin;
}

Origin origin_of(const fs::path& table) {
  if (std::string problem = batch::find_input(table).problem; !problem.empty()) return {false, problem};
  const std::string begin = '\n' + begin_of(table);
  if (begin.size() == 1) return {false, "is empty"};
  for (const std::string_view line : {"\n# digest ", "\n# format ", "\n# sha256 "})
    if (begin.find(line) != std::string::npos) return {true, ""};
  return {false, "says no program that wrote it"};
}

bool was_written_by(std::string_view program, const fs::path& directory) {
  if (!fs::is_directory(directory)) return false;
  const std::string begin = fmt::format("# {} ", program);
  return std::ranges::any_of(fs::directory_iterator(directory), [&](const fs::directory_entry& entry) {
    return entry.path().extension() == ".csv" && begin_of(entry.path()).starts_with(begin);
  });
}

std::string problem_of(const fs::path& file, const std::set<std::string>& sums) {
  std::error_code none;
  if (!fs::exists(file, none)) return "is missing";
  if (std::string problem = batch::find_input(file).problem; !problem.empty()) return problem;
  const std::string text = batch::read_input(file);
  if (sums.contains("")) return text.empty() ? "is empty" : "";
  const std::string sum = batch::sha256_of(text);
  if (sums.contains(sum) || sums.contains(batch::sha256_of(batch::without_carriage_returns(text)))) return "";
  return fmt::format("is not as it was written: its sha256 is {}, not {}", sum, *sums.begin());
}

CheckedPage check_page_file(const fs::path& page, bool of_map) {
  CheckedPage checked;
  checked.problem = batch::find_input(page).problem;
  if (!checked.problem.empty()) return checked;
  const bool marked = begin_of(page).find("\n<!-- sha256 ") != std::string::npos;
  if (!marked && !of_map) return checked;  // some other file, which may be of any size
  checked.text = batch::read_input(page);
  const batch::PageSum sum = batch::check_page(checked.text);
  checked.summed = sum != batch::PageSum::none;
  const std::string_view text = checked.text;
  const bool ends = text.substr(0, text.find_last_not_of("\r\n") + 1).ends_with("</html>");
  if (!ends) {
    checked.problem = "is cut off";
  } else if (sum == batch::PageSum::wrong) {
    checked.problem = "is not as it was written: its checksum is another one";
  }
  return checked;
}

std::optional<bool> are_cases_whole(const fs::path& file) {
  if (!begin_of(file).starts_with("rubdiagnose cases ")) return std::nullopt;
  const std::string bytes = batch::read_input(file);
  const std::string_view head = std::string_view(bytes).substr(0, bytes.find('\n'));
  return head.size() < bytes.size() &&
         head.ends_with(' ' + batch::sha256_of(std::string_view(bytes).substr(head.size() + 1)));
}

CheckedRecordings check_set(const fs::path& labels) {
  CheckedRecordings checked;
  try {
    batch::CsvReader rows(labels);
    const std::size_t file = rows.column("file");
    const auto sum = std::ranges::find(rows.header(), "sha256");
    checked.summed = sum != rows.header().end();
    const auto column = static_cast<std::size_t>(sum - rows.header().begin());
    while (rows.next()) {
      const std::string& name = rows.cells()[file];
      const std::string problem =
          problem_of(labels.parent_path() / name, {checked.summed ? rows.cells()[column] : std::string()});
      if (!problem.empty()) checked.faults.push_back(fmt::format("{}: {}", name, problem));
      checked.whole += problem.empty() ? 1U : 0U;
    }
  } catch (const IoError& error) {
    checked.faults.emplace_back(error.what());
  }
  return checked;
}

}  // namespace rubsweep::apps
