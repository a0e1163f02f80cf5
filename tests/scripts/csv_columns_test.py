import contextlib
import io

import csv_columns
from files import FileTest


class CsvColumns(FileTest):
    def test_prints_columns_in_the_order_asked_for(self):
        path = self.write("t.csv", "# x\na,b,c\n1,2,3\n4,,6\n")
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            csv_columns.main([path, "c", "b"])
        self.assertEqual(said.getvalue(), "3,2\n6,\n")
