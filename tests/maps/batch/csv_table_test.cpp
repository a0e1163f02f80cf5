#include "rubsweep/maps/batch/csv_table.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_csv.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Parses `text` as the content of a file table.csv.
CsvTable parse(const std::string& text) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "table.csv";
  std::ofstream(path, std::ios::binary) << text;
  return read_csv(path);
}

/// The error message without the directory before "table.csv".
std::string fault(const std::string& text) {
  const auto message = message_of<IoError>([&] { parse(text); });
  return message.substr(message.find("table.csv"));
}

/// No reader of a table may return a number that was not written.
TEST(CsvTable, IsNotReadWhereItsSumIsWrong) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "table.csv";
  TableFile file(path, {"rubfit 1", "abc", {}});
  file.write("value\n0.0384\n");
  file.commit();
  std::string text = read_whole_file(path), crlf;
  for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  std::ofstream(path, std::ios::binary) << crlf;
  EXPECT_EQ(read_csv(path).rows.at(0).at(0), "0.0384");
  text[text.size() - 2] = '5';
  std::ofstream(path, std::ios::binary) << text;
  const std::string said = message_of<DamagedTable>([&] { const CsvReader reader(path); });
  EXPECT_NE(said.find("without its lines '# format' and '# sha256'"), std::string::npos) << said;
}

TEST(CsvTableNumber, EveryBitPatternReadsBack) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (std::isnan(value)) continue;
    const std::string text = csv_number(value);
    ASSERT_EQ(bits(std::strtod(text.c_str(), nullptr)), bits(value)) << text;
  }
}

TEST(CsvTableNumber, CornersReadBack) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, Limits::min(), Limits::denorm_min(), Limits::max(), Limits::epsilon(),
                             Limits::infinity(), -Limits::infinity(), 1e22, 1e23, 0.1, 5e-324}) {
    EXPECT_EQ(bits(std::strtod(csv_number(value).c_str(), nullptr)), bits(value)) << value;
  }
}

TEST(CsvTableNumber, IsShort) {
  EXPECT_EQ(csv_number(0.1), "0.1");
  EXPECT_EQ(csv_number(48), "48");
  EXPECT_EQ(csv_number(1e-7), "1e-07");
  EXPECT_EQ(csv_number(std::nan("")), "");
}

TEST(CsvTableRow, QuotesOnlyWhereNeeded) {
  const auto row = [](std::vector<std::string> cells) { return csv_row(cells); };
  EXPECT_EQ(row({"45", "", "non_contact", " a b "}), "45,,non_contact, a b ");
  EXPECT_EQ(row({"a,b", "say \"x\"", "two\nlines"}), "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"");
  EXPECT_EQ(row({"#1", "#2"}), "\"#1\",#2");
  EXPECT_EQ(row({""}), "\"\"");
}

TEST(CsvTableRead, KeepsCommentsHeaderAndCellsApart) {
  const auto table = parse("# rubsweep 0.1\n#units: SI\nspeed_hz,class\n45,non_contact\n\n# later\n48,\n");
  EXPECT_EQ(table.comments, (std::vector<std::string>{"rubsweep 0.1", "units: SI", "later"}));
  EXPECT_EQ(table.header, (std::vector<std::string>{"speed_hz", "class"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"45", "non_contact"}, {"48", ""}}));
  EXPECT_EQ(table.lines, (std::vector<std::size_t>{4, 7}));
  EXPECT_EQ(table.path.filename(), "table.csv");
}

TEST(CsvTableRead, AcceptsOtherLineEnds) {
  const auto table = parse("# note\r\na,b\r\n1,\"2\"\r\n3,4");
  EXPECT_EQ(table.comments, std::vector<std::string>{"note"});
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"1", "2"}, {"3", "4"}}));
}

TEST(CsvTableRead, ReadsBackAnyText) {
  std::mt19937 random(3);
  const std::string alphabet = "ab ,\"\n\r#\t";
  const auto random_cell = [&] {
    std::string cell(random() % 5, ' ');
    for (char& c : cell) c = alphabet[random() % alphabet.size()];
    return cell;
  };
  for (const std::size_t columns : {1u, 3u}) {
    std::vector<std::string> header{"#a", "#b", "c"};
    header.resize(columns);
    std::string text = csv_row(header) + "\n";
    std::vector<std::vector<std::string>> rows;
    for (int i = 0; i < 500; ++i) {
      std::vector<std::string> row;
      for (std::size_t j = 0; j < columns; ++j) row.push_back(random_cell());
      text += csv_row(row) + "\n";
      rows.push_back(row);
    }
    const auto table = parse(text);
    EXPECT_EQ(table.header, header);
    EXPECT_EQ(table.rows, rows);
  }
}

TEST(CsvTableRead, NamesFileAndLineOfAFault) {
  EXPECT_EQ(fault("# c\na,b\n1,2\n3\n"), "table.csv:4: 1 cells, but the header has 2");
  EXPECT_EQ(fault("a,b\n\"1\n\",2\n1,2,3\n"), "table.csv:4: 3 cells, but the header has 2");
  EXPECT_EQ(fault("a,b\n1,\"2\n3,4\n"), "table.csv:2: a quoted cell is never closed");
  EXPECT_EQ(fault("a,b\n1,\"2\"3\n"), "table.csv:2: text after the closing quote of a cell");
  EXPECT_EQ(fault("a,b\n1,2\"3\n"), "table.csv:2: a quote inside an unquoted cell");
  EXPECT_EQ(fault("\na,b,a\n"), "table.csv:2: two columns are called 'a'");
  EXPECT_EQ(fault("# only\n"), "table.csv:2: no header line");
}

TEST(CsvTableRead, AbsentFileIsAnError) {
  EXPECT_EQ(message_of<IoError>([] { read_csv("/nowhere/map.csv"); }),
            "cannot read /nowhere/map.csv: No such file or directory");
}

TEST(CsvTableReader, FindsAColumnByItsName) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "table.csv";
  write_whole_file(path, "speed_hz,class\n45,chaotic\n");
  const CsvReader reader(path);
  EXPECT_EQ(reader.column("class"), 1u);
  const auto message = message_of<IoError>([&] { reader.column("order"); });
  EXPECT_TRUE(message.ends_with("table.csv: no column 'order', there are: speed_hz, class")) << message;
}

TEST(CsvTableReader, ReadsANumberExactlyOrRefusesIt) {
  const double value = 0.1 + 0.2;
  const TemporaryDirectory directory;
  const auto path = directory.path() / "table.csv";
  write_whole_file(path, "a,b\n" + csv_number(value) + ",\n\n1.5x,1e999\n-inf,+1\n");
  CsvReader reader(path);
  const auto refused = [&](std::size_t place) {
    const auto message = message_of<IoError>([&] { reader.number(place); });
    return message.substr(message.find("table.csv"));
  };
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(bits(reader.number(0)), bits(value));
  EXPECT_TRUE(std::isnan(reader.number(1)));
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(refused(0), "table.csv:4: a: '1.5x' is not a number");
  EXPECT_EQ(refused(1), "table.csv:4: b: '1e999' is not a number");
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.number(0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(refused(1), "table.csv:5: b: '+1' is not a number");
}

TEST(CsvTableReader, FindsItsRowsAgain) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  write_whole_file(path, "# first\na,b\n1,one\n\n# second\r\n2,\"two\n\"\"lines\"\"\"\r\n3,three");
  CsvReader reader(path);
  EXPECT_EQ(reader.header(), (std::vector<std::string>{"a", "b"}));
  std::vector<CsvReader::RowPosition> places;
  std::vector<std::vector<std::string>> rows;
  while (reader.next()) {
    places.push_back(reader.place());
    rows.push_back(reader.cells());
  }
  EXPECT_EQ(reader.comments(), (std::vector<std::string>{"first", "second"}));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1], (std::vector<std::string>{"2", "two\n\"lines\""}));
  EXPECT_EQ(places[1].line, 6u);
  EXPECT_EQ(places[2].line, 8u);
  for (const std::size_t i : std::vector<std::size_t>{2, 0, 1, 1}) {
    reader.read_at(places[i]);
    EXPECT_EQ(reader.cells(), rows[i]);
    EXPECT_EQ(reader.place().line, places[i].line);
    EXPECT_EQ(reader.number(0), static_cast<double>(i + 1));
  }
  EXPECT_TRUE(reader.next());
  EXPECT_EQ(reader.cells(), rows[2]);
  EXPECT_FALSE(reader.next());
}

}  // namespace
}  // namespace rubsweep::batch
