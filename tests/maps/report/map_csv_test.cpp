#include "rubsweep/maps/report/map_csv.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <utility>

#include "maps/batch/read_csv.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

namespace rubsweep::report {
namespace {

using sweep::Row;

/// Cells of a line by their column names.
std::map<std::string, std::string> by_column(const std::string& line) {
  const auto split = [](const std::string& text) {
    std::vector<std::string> cells(1);
    for (const char c : text) c == ',' ? cells.emplace_back() : cells.back() += c;
    return cells;
  };
  const auto names = split(map_header()), cells = split(line);
  EXPECT_EQ(cells.size(), names.size()) << line;
  std::map<std::string, std::string> result;
  for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) result[names[i]] = cells[i];
  return result;
}

Row full_row() {
  Row row;
  row.speed_hz = 75;
  row.whirl_ratio = 0.4;
  row.eccentricity_m = 3.36e-4;
  row.motion_class = response::motion::MotionClass::subharmonic;
  row.order = 2;
  row.measures.emplace();
  row.measures->turns = 48;
  row.measures->contact = {.hits = 72,
                           .contact_fraction = 0.125,
                           .peak_displacement_m = 2.5e-3,
                           .peak_contact_force_n = 1234.5,
                           .peak_casing_displacement_m = 3e-4};
  row.peak_over_clearance = 2.5;
  row.measures->amplitude_1x_forward_m = 4.56e-4;
  row.measures->amplitude_1x_backward_m = 2e-5;
  row.measures->dominant = {.order = -0.5, .amplitude_m = 1.5e-3};
  row.measures->orbit = response::spectrum::OrbitKind::oval;
  row.measures->whirl = response::spectrum::WhirlKind::backward;
  row.proof = response::motion::Proof::observed;
  row.robust = true;
  row.last_contact_revolution = 600;
  row.revolutions = 600;
  row.start = sweep::RunStart::kick;
  return row;
}

Row failed_row() {
  Row row;
  row.speed_hz = 60;
  row.whirl_ratio = 0.5;
  row.eccentricity_m = std::numeric_limits<double>::quiet_NaN();
  row.status = "unreachable";
  return row;
}

constexpr const char* contract =
    "speed_hz,whirl_ratio,eccentricity_m,class,order,orbit,whirl,proof,robust,comb_spacing,hits_per_"
    "revolution,"
    "contact_fraction,peak_displacement_m,peak_contact_force_n,amplitude_1x_forward_m,amplitude_1x_backward_"
    "m,"
    "dominant_order,dominant_amplitude_m,floquet_modulus,lyapunov_per_revolution,last_contact_revolution,"
    "revolutions,"
    "status,start,peak_casing_displacement_m,peak_over_clearance,chaos_life_revolutions,chaos_escapes,kind";

TEST(MapCsvHeader, IsTheContract) { EXPECT_EQ(map_header(), contract); }

TEST(MapCsvLine, OfARowWithEverything) {
  EXPECT_EQ(
      map_line(full_row()),
      "75,0.4,0.000336,subharmonic,2,oval,backward,observed,yes,,1.5,0.125,0.0025,1234.5,0.000456,2e-05,"
      "-0.5,0.0015,,,600,600,ok,kick,3e-04,2.5,,,subharmonic_2");
}

TEST(MapCsvLine, HowTheRunStarted) {
  Row row = full_row();
  EXPECT_EQ(by_column(map_line(row)).at("start"), "kick");
  row.start = sweep::RunStart::quiet;
  EXPECT_EQ(by_column(map_line(row)).at("start"), "quiet");
  row.start = sweep::RunStart::state;
  EXPECT_EQ(by_column(map_line(row)).at("start"), "state");
  row.start = sweep::RunStart::contact;
  EXPECT_EQ(by_column(map_line(row)).at("start"), "contact");
  EXPECT_TRUE(map_line(row).ends_with(",ok,contact,3e-04,2.5,,,subharmonic_2"));
}

TEST(MapCsvLine, OfChaosHowLongItLasts) {
  Row row = full_row();
  row.motion_class = response::motion::MotionClass::chaotic;
  row.survival = response::Survival{.turns = 1000, .escapes = 1};
  const auto cells = by_column(map_line(row));
  EXPECT_NEAR(std::stod(cells.at("chaos_life_revolutions")), 210.7986, 1e-3);
  EXPECT_EQ(cells.at("chaos_escapes"), "1");
}

TEST(MapCsvLine, ASensitiveCellSaysSo) {
  Row row = full_row();
  row.robust = false;
  EXPECT_EQ(by_column(map_line(row)).at("robust"), "no");
}

TEST(MapCsvLine, CombSpacingAndExponentStandInTheirOwnColumns) {
  Row row = full_row();
  EXPECT_EQ(by_column(map_line(row)).at("comb_spacing"), "");
  EXPECT_EQ(by_column(map_line(row)).at("lyapunov_per_revolution"), "");
  row.measures->comb_spacing = 2.6857;
  EXPECT_EQ(by_column(map_line(row)).at("comb_spacing"), "2.6857");
  EXPECT_EQ(by_column(map_line(row)).at("lyapunov_per_revolution"), "");
  row.measures->comb_spacing.reset();
  row.lyapunov_per_revolution = 0.1925;
  EXPECT_EQ(by_column(map_line(row)).at("comb_spacing"), "");
  EXPECT_EQ(by_column(map_line(row)).at("lyapunov_per_revolution"), "0.1925");
  row.lyapunov_per_revolution = 0;
  EXPECT_EQ(by_column(map_line(row)).at("lyapunov_per_revolution"), "0");
  row.measures.reset();
  EXPECT_EQ(by_column(map_line(row)).at("comb_spacing"), "");
}

TEST(MapCsvLine, WhatDoesNotApplyIsEmpty) {
  EXPECT_EQ(map_line(failed_row()), "60,0.5,,failed,,,,,,,,,,,,,,,,,,0,unreachable,,,,,,failed");
}

TEST(MapCsvLine, ARotorAtRestHasNoOrbitWhirlOrDominantLine) {
  Row row;
  row.motion_class = response::motion::MotionClass::non_contact;
  row.measures.emplace();
  row.measures->turns = 1;
  row.proof = response::motion::Proof::rest;
  const auto cells = by_column(map_line(row));
  for (const char* empty :
       {"orbit", "whirl", "dominant_order", "dominant_amplitude_m", "order", "last_contact_revolution"}) {
    EXPECT_EQ(cells.at(empty), "") << empty;
  }
  EXPECT_EQ(cells.at("hits_per_revolution"), "0");
  EXPECT_EQ(cells.at("amplitude_1x_forward_m"), "0");
  EXPECT_EQ(cells.at("class"), "non_contact");
  EXPECT_EQ(cells.at("proof"), "rest");
}

TEST(MapCsvLine, NumbersReadBackToTheSameBits) {
  std::mt19937_64 random(1);
  const auto awkward = [&] {
    return std::ldexp(static_cast<double>(random() >> 11), -53 - static_cast<int>(random() % 1000));
  };
  for (int trial = 0; trial < 500; ++trial) {
    Row row = full_row();
    auto& m = *row.measures;
    const std::vector<std::pair<const char*, double*>> numbers{
        {"speed_hz", &row.speed_hz},
        {"whirl_ratio", &row.whirl_ratio},
        {"eccentricity_m", &row.eccentricity_m},
        {"contact_fraction", &m.contact.contact_fraction},
        {"peak_displacement_m", &m.contact.peak_displacement_m},
        {"peak_contact_force_n", &m.contact.peak_contact_force_n},
        {"peak_casing_displacement_m", &m.contact.peak_casing_displacement_m},
        {"peak_over_clearance", &*row.peak_over_clearance},
        {"amplitude_1x_forward_m", &m.amplitude_1x_forward_m},
        {"amplitude_1x_backward_m", &m.amplitude_1x_backward_m},
        {"dominant_order", &m.dominant->order},
        {"dominant_amplitude_m", &m.dominant->amplitude_m}};
    for (const auto& [name, number] : numbers) *number = awkward();
    m.contact.hits = static_cast<int>(random() % 1000);
    const auto cells = by_column(map_line(row));
    for (const auto& [name, number] : numbers) {
      const double read_back = std::strtod(cells.at(name).c_str(), nullptr);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read_back), std::bit_cast<std::uint64_t>(*number)) << name;
    }
    EXPECT_EQ(std::strtod(cells.at("hits_per_revolution").c_str(), nullptr), m.contact.hits / 48.0);
  }
}

TEST(MapCsv, CommentsHeaderAndLinesAreATable) {
  const std::string text =
      map_comments() + map_header() + "\n" + map_line(full_row()) + "\n" + map_line(failed_row()) + "\n";
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  std::ofstream(path, std::ios::binary) << text;
  const batch::CsvTable table = batch::read_csv(path);
  ASSERT_EQ(table.comments.size(), 1u);
  EXPECT_TRUE(table.comments[0].starts_with("units: SI"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(batch::number(table, 0, batch::column(table, "dominant_order")), -0.5);
  EXPECT_TRUE(std::isnan(batch::number(table, 1, batch::column(table, "eccentricity_m"))));
  EXPECT_EQ(table.rows[1][batch::column(table, "status")], "unreachable");
}

TEST(MapCsvMapColumns, NamesAreDistinctAndSayTheUnit) {
  std::set<std::string_view> names;
  for (const MapColumn& column : map_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_EQ(column.name.ends_with("_m"), column.unit == "m") << column.name;
    EXPECT_EQ(column.name.ends_with("_n"), column.unit == "N") << column.name;
    EXPECT_EQ(column.name.ends_with("_hz"), column.unit == "Hz") << column.name;
    EXPECT_FALSE(column.description.empty()) << column.name;
  }
}

TEST(MapCsvMapColumns, PlacesAreThoseOfTheHeader) {
  const std::string header = map_header();
  EXPECT_TRUE(header.starts_with(map_columns().front().name));
  for (std::size_t i = 0; i < map_columns().size(); ++i) EXPECT_EQ(place_of_column(map_columns()[i].name), i);
  EXPECT_THROW(place_of_column("speed"), SolverError);
}

TEST(MapCsvMapColumns, OfEachComparison) {
  EXPECT_EQ(columns_compared(Comparison::key), "speed_hz, whirl_ratio");
  EXPECT_EQ(columns_compared(Comparison::label), "class, order");
  EXPECT_EQ(columns_compared(Comparison::text), "orbit, whirl");
}

/// Numbers that depend on the length of observation or on the success of a proof are not properties of the
/// cell.
TEST(MapCsvMapColumns, NumbersOfTheWayToTheVerdictAreNotCompared) {
  for (const char* name : {"proof", "floquet_modulus", "lyapunov_per_revolution", "last_contact_revolution",
                           "revolutions", "status", "start"})
    EXPECT_EQ(map_columns()[place_of_column(name)].comparison, Comparison::ignored) << name;
}

std::string document(const std::string& name) {
  std::ifstream file(RUBSWEEP_TEST_DATA "/../../../docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Every column must be explained in the reference, and every class in the guide.
TEST(MapCsvMapColumns, AndClassesStandInTheDocumentsAndInTheHelp) {
  const std::string columns_page = document("reference/columns.md"),
                    guide = document("guide/reading-a-map.md");
  const std::string help = describe_map_columns();
  const auto expect_both = [&](const std::string& page, std::string_view word) {
    EXPECT_NE(page.find(fmt::format("`{}`", word)), std::string::npos) << word;
    EXPECT_NE(help.find(fmt::format("\n  {} ", word)), std::string::npos) << word;
  };
  for (const MapColumn& column : map_columns()) expect_both(columns_page, column.name);
  std::istringstream of_studies(describe_study_columns());
  for (std::string line; std::getline(of_studies, line);)
    if (line.starts_with("  ")) expect_both(columns_page, line.substr(2, line.find(' ', 2) - 2));
  for (const auto motion_class : response::motion::motion_classes)
    expect_both(guide, to_string(motion_class));
}

}  // namespace
}  // namespace rubsweep::report
