import unittest

from rubplot import failure


class RequireReadable(unittest.TestCase):
    def test_a_directory_is_no_readable_file(self):
        with self.assertRaisesRegex(failure.Failure, "cannot read /$"):
            failure.require_readable("/")
