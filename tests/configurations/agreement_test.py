"""agreement_test.py TOP PROGRAMS READ_MANY [COUNT]: the schemas that the programs print and the readers say the same of all
shipped configurations, and of COUNT mutated ones (600 unless said otherwise). Both go by the same lists of keys
(model/key.hpp), so that this is a test of what these lists do not hold: which keys exclude or need each other. The schema
is judged by python3-jsonschema and by node-ajv, which must agree. What only the reader refuses must be a rule of RULES,
which docs/keys.md lists.
"""

import glob
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
    import yaml
except ImportError:  # Debian: python3-jsonschema, python3-yaml
    sys.exit(77)

import mutations
from unsayable import RULES

TOP, PROGRAMS, READ_MANY = sys.argv[1:4]
COUNT = int(sys.argv[4]) if len(sys.argv) > 4 else 600
KINDS = {"run": "rubsweep", "ring": "ringstab"}


class Loader(yaml.SafeLoader):
    """YAML 1.2 as the reader and editors take it: no `on` is a truth value, and 1e3 is a number."""


Loader.yaml_implicit_resolvers = {}
Loader.add_implicit_resolver("tag:yaml.org,2002:null", re.compile(r"^(~|null|Null|NULL|)$"), list("~nN") + [""])
Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile(r"^(true|false)$"), list("tf"))
Loader.add_implicit_resolver("tag:yaml.org,2002:int", re.compile(r"^[-+]?[0-9]+$"), list("-+0123456789"))
Loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$"),
                             list("-+.0123456789"))
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))


def load(text):
    """A configuration with the keys as they are written: a number there is a name."""
    return _with_names(yaml.load(text, Loader))


def _with_names(value):
    if isinstance(value, dict):
        return {str(key): _with_names(inner) for key, inner in value.items()}
    return [_with_names(inner) for inner in value] if isinstance(value, list) else value


def kind_of(path):
    of_ring = os.path.basename(os.path.dirname(path)) == "ring" or os.path.basename(path).startswith("ring")
    return "ring" if of_ring else "run"


def shipped():
    """Files of configurations that are whole, or are so with their base; those of rubdata and rubdiagnose have none."""
    files = glob.glob(os.path.join(TOP, "configs", "**", "*.yaml"), recursive=True)
    own = os.path.join(TOP, "configs", "recordings", "")
    return sorted(file for file in files if os.path.basename(file) != "stop.yaml" and not file.startswith(own))


def printed(program, *arguments):
    return subprocess.run([os.path.join(PROGRAMS, program), *arguments], check=True, capture_output=True, text=True).stdout


class Judges:
    """Both validators and the reader, of one kind of configuration."""

    def __init__(self, kind, folder):
        self.kind, self.folder = kind, folder
        self.schema = json.loads(printed(KINDS[kind], "--schema"))
        jsonschema.Draft7Validator.check_schema(self.schema)
        self.path = os.path.join(folder, kind + ".schema.json")
        with open(self.path, "w", encoding="utf-8") as file:
            json.dump(self.schema, file)

    def by_jsonschema(self, values):
        validator = jsonschema.Draft7Validator(self.schema)
        return [validator.is_valid(value) for value in values]

    def by_ajv(self, values):
        judge = os.path.join(os.path.dirname(os.path.abspath(__file__)), "ajv_judge.js")
        asked = subprocess.run(["node", judge, self.path], check=True, capture_output=True, text=True,
                               input="".join(json.dumps(value) + "\n" for value in values),
                               env={**os.environ, "NODE_PATH": "/usr/share/nodejs"})
        return [line == "ok" for line in asked.stdout.split("\n")[:-1]]

    def by_reader(self, values):
        files = []
        for i, value in enumerate(values):
            files.append(os.path.join(self.folder, f"{self.kind}_{i}.yaml"))
            with open(files[-1], "w", encoding="utf-8") as file:
                json.dump(value, file)
        return self.read(files)

    def read(self, files):
        """ "ok" or the problems of each file, parted by tabs."""
        asked = subprocess.run([READ_MANY], check=True, capture_output=True, text=True,
                               input="".join(f"{self.kind} {file}\n" for file in files))
        return asked.stdout.split("\n")[:-1]


def sayable(problem, value):
    """Whether a schema could say it of this configuration."""
    return not any(re.search(rule, problem) for rule in RULES.values()) and not is_of_an_axis(problem, value)


def is_of_an_axis(problem, value):
    """Whether it is told of a number that an axis or a study writes over the configuration: its section is not there, or
    another number stands in its place."""
    section = re.search(r"yaml:\d+:\d+: (\w+)\.\w+: missing", problem)
    number = re.search(r"yaml:\d+:\d+: ([\w.]+): (\S+) is out of range", problem)
    if section:
        return section[1] not in value
    if not number:
        return False
    try:
        return float(number[2]) != number_at(value, number[1])
    except (ValueError, IndexError):
        return False


def number_at(value, path):
    """The number at a path such as stops.0.clearance_m; empty where there is none."""
    for key in path.split("."):
        if isinstance(value, list):
            value = value[int(key)]
        elif isinstance(value, dict):
            value = value.get(key)
    return value if isinstance(value, (int, float)) else None


class Agreement(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.judges = {kind: Judges(kind, cls.folder) for kind in KINDS}

    def test_shipped_configurations(self):
        files = shipped()
        self.assertGreater(len(files), 50)
        for kind, judges in self.judges.items():
            of_kind = [file for file in files if kind_of(file) == kind]
            values = []
            for file in of_kind:
                with open(file, encoding="utf-8") as text:
                    values.append(load(text.read()))
            for file, first, second, read in zip(of_kind, judges.by_jsonschema(values), judges.by_ajv(values),
                                                 judges.read(of_kind)):
                self.assertEqual((first, second, read), (True, True, "ok"), file)

    def test_mutated_configurations(self):
        counts = {"accepted": 0, "refused by both": 0, "refused by the reader alone": 0}
        wrong = []
        for kind, judges in self.judges.items():
            files = [file for file in shipped() if kind_of(file) == kind]
            seeds = [load(printed(KINDS[kind], file, "--print-config")) for file in files]
            tests_of_readers = ["ring"] if kind == "ring" else ["maps", "config"]
            extra = sorted(glob.glob(os.path.join(TOP, "tests", *tests_of_readers, "*.yaml")))
            for file in extra:
                if judges.read([file]) == ["ok"]:
                    seeds.append(load(printed(KINDS[kind], file, "--print-config")))
            mutator = mutations.Mutator(seeds, judges.schema, random.Random(20260101))
            made = [mutator.mutated() for _ in range(COUNT * 3 // 4 if kind == "run" else COUNT - COUNT * 3 // 4)]
            values = [value for _, value in made]
            for (mutation, value), first, second, read in zip(made, judges.by_jsonschema(values), judges.by_ajv(values),
                                                              judges.by_reader(values)):
                accepted = read == "ok"
                if first != second:
                    wrong.append(f"{mutation}: jsonschema {first}, ajv {second}: {json.dumps(value)}")
                elif accepted and not first:
                    wrong.append(f"{mutation}: refused by the schema alone: {json.dumps(value)}")
                elif not accepted and first and any(sayable(problem, value) for problem in read.split("\t")):
                    wrong.append(f"{mutation}: refused by the reader alone: {read}")
                counts["accepted" if accepted else "refused by the reader alone" if first else "refused by both"] += 1
        print(f"\n{sum(counts.values())} mutated: " + ", ".join(f"{count} {what}" for what, count in counts.items()))
        self.assertFalse(wrong, "\n".join([str(len(wrong))] + wrong[:40]))
        self.assertGreater(counts["accepted"], COUNT // 20)

    def test_rules_are_listed(self):
        with open(os.path.join(TOP, "docs", "keys.md"), encoding="utf-8") as file:
            text = " ".join(file.read().split())
        for rule in RULES:
            self.assertIn(rule, text)


if __name__ == "__main__":
    if shutil.which("node") is None or not os.path.isdir("/usr/share/nodejs/ajv"):
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
