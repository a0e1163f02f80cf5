#!/usr/bin/env python3
"""suite_names_test.py TESTS: every suite of a file NAME_test.cpp begins with NAME in capitals (RotorKit in
rotor_kit_test.cpp), so that `ctest -R RotorKit` runs what the file holds. Lists the suites that do not."""
import pathlib
import re
import sys

SUITE = re.compile(r"^\s*(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+)", re.MULTILINE)


def misnamed(stem: str, text: str) -> list[str]:
    begin = "".join(word.capitalize() for word in stem.split("_"))
    return sorted({name for name in SUITE.findall(text) if not name.lower().startswith(begin.lower())})


def main() -> int:
    assert misnamed("rotor_kit", "TEST(RotorKit, A) {}\n  TEST_F(Kit, B) {}") == ["Kit"]
    files = sorted(pathlib.Path(sys.argv[1]).rglob("*_test.cpp"))
    assert files, f"no tests under {sys.argv[1]}"
    broken = False
    for file in files:
        for name in misnamed(file.name.removesuffix("_test.cpp"), file.read_text(encoding="utf-8")):
            print(f"{file}: suite {name} is not named after its file")
            broken = True
    return int(broken)


sys.exit(main())
