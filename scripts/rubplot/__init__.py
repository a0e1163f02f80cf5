"""Pictures of everything that the programs write, by gnuplot."""

VERSION = "0.2.0"  # version of the programs whose tables it draws
