import json
import os

import count_rebuilds
from files import FileTest
from rubplot.failure import Failure

NINJA = """rule CXX_COMPILER__a
build a.o: CXX_COMPILER__a a.cpp || order
build liba.a: CXX_STATIC_LIBRARY_LINKER__a a.o
build digest.cpp | ${dir}digest.cpp: CUSTOM_COMMAND liba.a
build digest.o: CXX_COMPILER__d digest.cpp
build b.o: CXX_COMPILER__b b.cpp
build one b.txt: CXX_EXECUTABLE_LINKER__one b.o | liba.a
build two: CXX_EXECUTABLE_LINKER__two digest.o
build three: CXX_EXECUTABLE_LINKER__three b.o || liba.a
build all: phony one two three
"""


class CountRebuilds(FileTest):
    def tree(self):
        """A tree of two sources, one of them in a batch, and the commands of its build."""
        top = os.path.realpath(os.path.dirname(self.write("build.ninja", NINJA)))
        for folder in ("lib/k", "build"):
            os.makedirs(os.path.join(top, folder), exist_ok=True)
        self.write("lib/k/low.hpp", "#pragma once\n#include <vector>\n")
        self.write("lib/k/high.hpp", '#include "k/low.hpp"\n// #include "k/never.hpp"\n')
        self.write("lib/k/never.hpp", "")
        self.write("a.cpp", '#include "k/high.hpp"\n')
        self.write("batch.cpp", f'#include "{top}/a.cpp"\n')
        self.write("b.cpp", '#include <vector>\n')
        self.write("pch.hxx", "#include <k/low.hpp>\n")
        commands = [f"c++ -I{top}/lib -o a.o -c {top}/batch.cpp",
                    f"c++ -I{top}/lib -include {top}/pch.hxx -o b.o -c {top}/b.cpp",
                    f"c++ -o pch.gch -c {top}/pch.hxx"]
        self.write("compile_commands.json", json.dumps(
            [{"directory": top, "command": command, "file": command.split()[-1]} for command in commands]))
        return top

    def test_objects_links_and_headers(self):
        top = self.tree()
        rows = count_rebuilds.count_rebuilds(top, top, ["lib/k/low.hpp", "lib/k/high.hpp", "a.cpp", "lib/k/never.hpp"])
        self.assertEqual(rows, [("lib/k/low.hpp", 2, 3, 0), ("lib/k/high.hpp", 1, 2, 1), ("a.cpp", 1, 2, 2),
                                ("lib/k/never.hpp", 0, 0, 0)])

    def test_a_file_that_is_not_there_is_said(self):
        top = self.tree()
        with self.assertRaises(Failure):
            count_rebuilds.count_rebuilds(top, top, ["gone.hpp"])
