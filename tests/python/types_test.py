"""mypy finds no fault in the package, by its strict rules; it has at most 1200 lines. 77 where mypy is not installed."""

import shutil
import subprocess
import sys
from pathlib import Path

package = Path(__file__).resolve().parents[2] / "apps" / "python" / "rubsweep"
lines = sum(len(path.read_text(encoding="utf-8").splitlines()) for path in package.glob("*.py"))
if lines > 1200:
    sys.exit(f"the package has {lines} lines, at most 1200 are meant")
mypy = shutil.which("mypy")
if mypy is None:
    print("skipped: no mypy (Debian package: mypy)")
    sys.exit(77)
sys.exit(subprocess.run([mypy, "--strict", "--ignore-missing-imports", "--python-version", "3.9", "--python-executable", sys.executable,
                         "--cache-dir", "/dev/null", str(package)], check=False).returncode)
