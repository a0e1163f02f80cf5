#!/usr/bin/env bash
# reference_figures.sh [FIGURE]...: motions of the reference machine: 04, 05, 07, 08, 10, 13, rotor_kit, or all of them.
figures=("${@/#/reference-}")
exec python3 "$(dirname "${BASH_SOURCE[0]}")/rubplot" figure "${figures[@]:-reference}"
