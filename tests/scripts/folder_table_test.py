import os

import folder_table
from files import FileTest
from rubplot.failure import Failure

SCRIPT = """declare -A stands_on=(
  [core]=''
)
declare -A below=(
  # Errors.
  [.]=''
  # Plain structs
  # of a machine.
  [model]='.'
  # Many cells.
  [sweep]='model batch'
)
later=(
  [other]=''
)
"""


class FolderTable(FileTest):
    def test_folders_stand_by_storeys_with_what_they_stand_on_and_hold(self):
        for place in ("core/model", "maps/sweep"):
            os.makedirs(self.path(os.path.join("lib", "rubsweep", place)))
        lines = folder_table.as_table(SCRIPT, self.path("lib")).splitlines()
        self.assertEqual(lines[2:], ["| `core` | | Errors. |", "| `core/model` | | Plain structs of a machine. |",
                                     "| `maps/sweep` | `model`, `batch` | Many cells. |"])

    def test_a_folder_without_a_word_or_a_place_is_refused(self):
        with self.assertRaisesRegex(Failure, "nothing is said of the folder model"):
            list(folder_table.folders(SCRIPT.replace("  # Plain structs\n  # of a machine.\n", "")))
        with self.assertRaisesRegex(Failure, "no storey"):
            folder_table.as_table(SCRIPT, self.path("lib"))
