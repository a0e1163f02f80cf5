#include "report_program.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "rubreport/no_report.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "shared/child_process.hpp"
#include "shared/command_line.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

constexpr const char* report_program = "rubreport";

/// Limit of a child's output; a summary is smaller, because it has 1000 messages at most.
constexpr std::size_t most_output_bytes = 16'000'000;

/// A file in memory for the output of a child.
batch::Descriptor memory_file() {
  batch::Descriptor file(::memfd_create(report_program, MFD_CLOEXEC));
  if (file.get() < 0) batch::throw_io_error("write", "output of rubreport", errno);
  return file;
}

/// Prints the output of a child, and adds its summary to this program's.
void pass_on(const batch::Descriptor& output) {
  std::string text;
  ::lseek(output.get(), 0, SEEK_SET);
  if (const int error = batch::read_bytes(output.get(), most_output_bytes, text))
    batch::throw_io_error("read", "output of rubreport", error);
  print_text(take_summary(std::move(text)));
}

int say_interrupted(std::string_view program) {
  say(fmt::format("{}: interrupted; {}\n", program, no_report));
  return 128 + caught_signal();
}

}  // namespace

void require_report_program() {
  const std::filesystem::path file = sibling(report_program);
  if (::access(file.c_str(), X_OK) == 0) return;
  throw IoError(fmt::format(
      "--report: there is no {}, which writes it, allowed: build {} as well, or install all programs",
      file.string(), report_program));
}

int write_report(std::string_view program, const RubsweepArguments& arguments,
                 const std::filesystem::path& directory) {
  const std::atomic<bool>& stop = catch_interrupts();
  if (stop) return say_interrupted(program);
  // The child's lines must come after the lines printed here. If stdout fails, the child prints nothing.
  const int unprinted = std::fflush(stdout) != 0 ? errno : 0;
  std::vector<std::string> command{std::string(program), "--threads", std::to_string(arguments.threads),
                                   "--progress", progress_word(arguments.progress)};
  if (arguments.quiet || unprinted != 0) command.emplace_back("--quiet");
  std::optional<batch::Descriptor> output;
  if (summary_is_wanted()) {
    command.insert(command.end(), {"--summary", "json"});
    output.emplace(memory_file());
  }
  command.insert(command.end(), {"--", directory.string()});
  const ChildEnd end = run_child_until(stop, sibling(report_program), std::move(command),
                                       {.output = output ? std::optional(output->get()) : std::nullopt});
  if (output) pass_on(*output);
  if (unprinted != 0) throw std::system_error(unprinted, std::generic_category(), "standard output");
  if (!end.by_signal) return stop && end.code == 128 + SIGTERM ? 128 + caught_signal() : end.code;
  if (stop) return say_interrupted(program);
  say(fmt::format("{}: {} was ended by signal {}; {}\n", program, report_program, end.code, no_report));
  return software_fault;
}

}  // namespace rubsweep::apps
