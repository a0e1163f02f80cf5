"""`python3 scripts/rubplot ...`, and what the installed program rubplot starts."""

import os
import sys

sys.dont_write_bytecode = True
# The package is found beside this file's folder, wherever it is installed, and nothing in the folder shadows a module.
sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

from rubplot.command_line import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
