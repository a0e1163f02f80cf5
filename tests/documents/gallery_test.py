"""gallery_test.py [--diagnoses] TOP PROGRAMS...: runs every command of docs/gallery.md in a directory of its own, with the
directories of the programs in the PATH; the sections of rubdiagnose, which take as long as all others, with --diagnoses alone.

Each must succeed, and behind the commands of a section its picture must be there: the file of the name that the section
shows, or a page of that name. Each file of configs/gallery/ must be used, and say purpose, run time and title. A section
whose program was not built is left out by name. Exits with 77 where there is no gnuplot. RUBSWEEP_GALLERY names a directory
that keeps what was made."""

import os
import re
import shutil
import subprocess
import sys
import tempfile


def sections(text):
    """The heading, commands and pictures of every section that has commands."""
    for part in re.split(r"^#+ ", text, flags=re.MULTILINE)[1:]:
        commands = "".join(line[4:] + "\n" for line in part.splitlines() if line.startswith("    "))
        if commands:
            yield part.splitlines()[0], commands, re.findall(r"!\[[^\]]*\]\(([^)]*)\)", part)


def run(heading, commands, pictures, work, environment):
    """Faults of a section; nothing where all is well."""
    ran = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=work, env=environment, text=True,
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ran.returncode != 0:
        yield f"{heading}: exit code {ran.returncode}\n{commands}{ran.stdout}"
    if len(pictures) != 1:
        yield f"{heading}: {len(pictures)} pictures, expected one"
    for picture in pictures:
        stem = os.path.splitext(os.path.basename(picture))[0]
        made = [name for name in (f"{stem}.png", f"{stem}.html") if os.path.isfile(os.path.join(work, name))]
        if not made or os.path.getsize(os.path.join(work, made[0])) < 2000:
            yield f"{heading}: no {stem}.png\n{ran.stdout}"


def unlike_others(directory, text):
    """Configurations that the gallery does not show, or that do not say purpose and run time."""
    for name in sorted(os.listdir(directory)):
        if f"configs/gallery/{name}" not in text:
            yield f"configs/gallery/{name}: not in docs/gallery.md"
        with open(os.path.join(directory, name), encoding="utf-8") as file:
            if not re.match(r"# [^\n]*\n(# [^\n]*\n)*# Run time: [^\n]*\ntitle: ", file.read()):
                yield f"configs/gallery/{name}: expected comments, '# Run time: ...', then a title"


def main(*arguments):
    diagnoses = arguments[:1] == ("--diagnoses",)
    top, *directories = arguments[diagnoses:]
    with open(os.path.join(top, "docs", "gallery.md"), encoding="utf-8") as file:
        text = file.read()
    # Everybody is root in a container, and a machine may have fewer processors than ranks.
    environment = {**os.environ, "PATH": os.pathsep.join([*directories, os.environ["PATH"]]),
                   "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl": "self,vader"}
    if not shutil.which("gnuplot"):
        print("skipped: there is no gnuplot")
        return 77
    wrong = list(unlike_others(os.path.join(top, "configs", "gallery"), text))
    with tempfile.TemporaryDirectory() as work:
        for name in ("configs", "scripts"):
            os.symlink(os.path.join(top, name), os.path.join(work, name))
        for heading, commands, pictures in sections(text):
            if ("rubdiagnose" in commands) != diagnoses:
                continue
            if "rubsweep-mpi" in commands and not shutil.which("rubsweep-mpi", path=environment["PATH"]):
                print(f"left out, as there is no rubsweep-mpi: {heading}")
                continue
            wrong += run(heading, commands, pictures, work, environment)
        if keep := os.environ.get("RUBSWEEP_GALLERY"):
            shutil.copytree(work, keep, ignore=shutil.ignore_patterns("configs", "scripts"), dirs_exist_ok=True)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
