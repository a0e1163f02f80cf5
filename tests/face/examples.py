"""examples.py FOLDER OUTPUT: makes one program of the examples in the comments of all headers in FOLDER."""

import pathlib
import re
import sys

folder, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
headers = sorted(folder.glob("*.hpp"))
includes, functions, calls = [], [], []
for header in headers:
    text = header.read_text(encoding="utf-8")
    match = re.search(r"^/// ```cpp\n((?:///.*\n)+?)/// ```$", text, re.MULTILINE)
    if not match:
        sys.exit(f"{header}: holds no example, allowed: a block between /// ```cpp and /// ```")
    line = text[: match.start(1)].count("\n") + 1
    code = re.sub(r"^/// ?", "", match.group(1), flags=re.MULTILINE)
    includes.append(f'#include "rubsweep/{header.name}"')
    functions.append(f'void {header.stem}() {{\n#line {line} "{header}"\n{code}}}\n')
    calls.append(f'    {{"{header.stem}", examples::{header.stem}}},')

output.write_text(
    "\n".join(includes)
    + """
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace examples {
namespace {

"""
    + "\n".join(functions)
    + """
}  // namespace
}  // namespace examples

int main() {
  struct Example {
    const char* name;
    void (*run)();
  };
  const Example all[] = {
"""
    + "\n".join(calls)
    + """
  };
  int failed = 0;
  for (const Example& example : all) {
    std::printf("--- %s\\n", example.name);
    try {
      example.run();
    } catch (const std::exception& error) {
      std::printf("%s failed: %s\\n", example.name, error.what());
      ++failed;
    }
  }
  return failed == 0 ? 0 : 1;
}
""",
    encoding="utf-8",
)
