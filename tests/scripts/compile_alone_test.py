import io
import json
import os
from contextlib import redirect_stdout

import compile_alone
from files import FileTest


class CompileAlone(FileTest):
    def database(self):
        """Sources of two folders whose compiler says no to what holds the word `wrong`."""
        compiler = self.write(
            "cc.sh", 'for last; do :; done\n[ "$last" = -fsyntax-only ] || exit 9\n! grep wrong "$1" >&2\n')
        top = os.path.dirname(compiler)
        entries = []
        for name, text in (("a/good.cpp", "right"), ("a/bad.cpp", "wrong"), ("a/below/bad.cpp", "wrong"),
                           ("b/good.cpp", "right")):
            path = self.write(name, text)
            entries.append({"directory": top, "file": path, "command": f"sh {compiler} {path} -o {name}.o -c {path}"})
        self.write("compile_commands.json", json.dumps(entries))
        return top

    def said(self, *arguments):
        heard = io.StringIO()
        with redirect_stdout(heard), self.assertRaises(SystemExit) as end:
            compile_alone.main(list(arguments))
        return end.exception.code, heard.getvalue()

    def test_only_sources_of_the_folders_are_read(self):
        top = self.database()
        self.assertEqual(self.said(top, "1", os.path.join(top, "b")), (0, "1 sources compiled alone, 0 refused\n"))
        code, text = self.said(top, "1", os.path.join(top, "a"), os.path.join(top, "b"))
        self.assertEqual((code, text), (1, "wrong\n3 sources compiled alone, 1 refused\n"))

    def test_what_the_time_leaves_out_is_counted(self):
        top = self.database()
        self.assertEqual(self.said(top, "0", os.path.join(top, "a")),
                         (0, "2 of 2 sources left out: the time is up\n0 sources compiled alone, 0 refused\n"))
