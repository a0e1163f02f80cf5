#!/usr/bin/env bash
# all_figures.sh: every map and every behaviour panel, as results/figures/*.png and .svg. Computes the maps that results/ does
# not hold: about three minutes on two cores for all of them, then one.
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure all
