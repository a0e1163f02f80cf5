"""Pictures of everything that the programs write, by gnuplot."""
