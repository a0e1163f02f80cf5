#!/usr/bin/env bash
# check_layers.sh [LIB]: every storey of LIB/rubsweep includes only itself and those it stands on, and every folder only
# folders below it; quoted includes name files that exist, and only config/yaml/ knows yaml-cpp. Lists each include that
# breaks a rule; exits 1 if there is any.
set -euo pipefail
lib=${1:-$(dirname "${BASH_SOURCE[0]}")/../lib}

[[ -d $lib/rubsweep ]] || { echo "no directory $lib/rubsweep"; exit 1; }

# Storeys that each storey stands on. The ring is a storey of one folder.
declare -A stands_on=(
  [core]=''
  [maps]='core'
  [analysis]='maps core'
  [measurement]='analysis maps core'
  [ring]='maps core'
)

# Folders that each folder may include directly, each without its storey; with each come those that it may include. `.` is
# the storey `core` itself. The comment above a folder says what it holds: the table of docs/architecture.md is made of them.
declare -A below=(
  # Errors, and the table of all enumerators (`core/error.hpp`, `core/vocabulary.hpp`).
  [.]=''
  # Counts where starts lead: points of low discrepancy, shares, uncertainty exponent, basin entropy; no physics.
  [basin]='.'
  # Runs many cells: threads, journals, locks, progress, CSV, whole files, sets of result files; no physics.
  [batch]='.'
  # Plain structs: rotor, casing, stop, friction, kick, with the allowed range of every number.
  [model]='.'
  # Force law, contact modes and their guards, friction coefficient, restitution, Hertz line contact, curved laws.
  [contact]='model numerics'
  # Linear systems (mass, damping, stiffness, points) made from parts: Jeffcott rotor; beam shaft and its reduction;
  # the speed from which on a free vibration grows.
  [structure]='model numerics'
  # Everything that one run simulates at one speed: structure, contacts, forces, start; the quiet motion in closed
  # form.
  [scene]='contact structure'
  # Decompositions of dense matrices (Cholesky, LU, QR, eigenvalues), each compiled in one place.
  [numerics/dense]=''
  # Mathematics without machines: flows of 2 x 2 pairs and of matrices, exponential series, modal form, a
  # least-recently-used cache, random numbers by SplitMix64, matrix-vector products with the same bits everywhere,
  # certified steps, roots in Bernstein form, the maximum of a cubic, cheapest assignments.
  [numerics]='. numerics/dense'
  # Decompositions of Hermitian matrices and of pairs of symmetric matrices, and singular values: no map needs them,
  # so `rubsweep` does not compile them.
  [numerics/spectral]='numerics/dense'
  # Question and answer of one turn, options, outcomes; units; the scene in scaled units; pulses and impulses.
  [integrate/run]='scene'
  # The rate of a state by the law of contact and friction: touching, slipping and sticking contacts, holding
  # forces, derivatives.
  [integrate/law]='integrate/run numerics'
  # Odeint steppers with location of every change of contact mode; steps by series for contacts by a power.
  [integrate/adaptive]='integrate/law integrate/taylor'
  # The contact modes of a machine as matrices, flows, guards and responses to harmonic forces, see [the
  # modes](#the-modes-of-the-exact-solver).
  [integrate/exact/modes]='integrate/run numerics'
  # A turn in closed form: certified steps to the end of a contact mode, contacts held by dry friction, tangent
  # vectors, watches.
  [integrate/exact]='integrate/exact/modes'
  # The tube about an orbit: widths of all motions that begin near it, over a turn and through its changes of mode.
  [integrate/exact/tube]='integrate/exact'
  # Motion as power series within a contact mode, any stop and any friction; creep in steep friction; guards as
  # polynomials; tangent vectors.
  [integrate/taylor]='integrate/law'
  # `start` begins a run by the solver that fits; `hybrid_run` changes between closed forms and Taylor pieces.
  [integrate]='integrate/adaptive integrate/exact integrate/taylor'
  # The rotor without stops: run-up, free decay, Bode plot, their identification; Campbell diagram, critical speeds,
  # mode shapes.
  [linear]='batch scene numerics numerics/spectral response/spectrum'
  # Full spectrum, discrete lines, combs, shape and direction of the orbit.
  [response/spectrum]='.'
  # Least squares within bounds with uncertainties; ring-down and 1X of a machine, steady or on a ramp, in closed
  # form; measured tables.
  [fit]='batch linear table'
  # MATLAB files, with their checksums and a limit; files of version 7.3 by HDF5, opened when needed.
  [matlab]='.'
  # Tables as people and instruments write them: encodings, cells, names, units, rows.
  [table]='.'
  # Recordings of instruments: tables of any form, units, marks of a keyphasor, readings at equal angles of the
  # shaft, faults.
  [recording]='config matlab response/spectrum'
  # The motion of a recording: period, lines, shape and whirl with their uncertainty.
  [scope]='batch recording response/spectrum'
  # Machines with stops drawn from ranges, rotor kits drawn from the keys that a fit leaves open, and their settled
  # motions.
  [diagnose]='batch response'
  # Features of a motion: shares of lines, phases, shape and whirl, whatever its size, direction and mark.
  [diagnose/features]='diagnose'
  # Random forest as kernel of a posterior, and the test whether an observation belongs to its population; no
  # physics.
  [diagnose/forest]='batch diagnose'
  # Cases drawn from the priors, their table on the disk, the posterior, the use of a further measurement.
  [diagnose/inference]='diagnose/features diagnose/forest matlab'
  # The answer of `rubdiagnose`: text, JSON, tables, the recording laid over the closest case.
  [diagnose/answer]='diagnose/inference'
  # Sets of labelled recordings: readings, labels, files, datasheet.
  [dataset]='diagnose recording'
  # `diagnose_recording`: recording, machine and candidates as one problem, kept motions, the answer; intervals of
  # the machine from its configuration and its fit.
  [diagnosis]='dataset diagnose/answer scope'
  # The classes, the measures of a motion, and the windows in which they are taken.
  [response/motion]='response/spectrum integrate'
  # Section map, periodic orbits and their multipliers, the ball behind `floquet`, the proof of rest.
  [response/proof]='response/motion integrate/exact/tube'
  # Centred annular stops: the rotating frame, its equilibria and limit cycles, their proofs.
  [response/rotating]='response/proof'
  # `settle` runs a cell until its motion is known; aperiodic motions and their exponent.
  [response]='response/proof response/rotating'
  # Periodic orbits and ovals of a scene as fixed points of a map of one or two parameters, their contacts and
  # multipliers, and the orbit that a cell settles on.
  [branch/orbits]='batch response'
  # The engine `continuation` and `segment`, a piece of a curve; `follow`: orbits along one parameter; test
  # functions of events, grazes, doubled branches.
  [branch/continuation]='branch/orbits numerics/spectral'
  # Lines of the rubs of machines whose numbers differ little, for a fit.
  [fit/rub]='branch/continuation fit'
  # `follow_curve`: folds, doublings, tori, branch points and grazes in two parameters, by their extended systems,
  # and their meetings.
  [branch/curves]='branch/continuation'
  # Families of orbits over a map, the reasons of their edges, and the labels that contradict them.
  [branch/families]='branch/continuation sweep'
  # One run with everything kept: samples, sections, mode switches, contact forces; readings of probes and the
  # period in them.
  [trace]='batch response'
  # One cell to one row; all cells to a map.
  [sweep]='basin response batch'
  # The design check: unbalance response against vibration limit and clearances, dry whip, kicks; its page and
  # tables.
  [design]='linear sweep'
  # Cells along a line: each from its kick, or from the motion of its neighbour; section and spectrum of the settled
  # motion.
  [line]='sweep trace'
  # Run-up and run-down through rub by the adaptive solver.
  [ramp]='integrate'
  # Loads rubbing on an elastic ring: matrices, eigenvalues, onsets, closed forms, stability charts.
  [ring]='config numerics'
  # Documents, values, sections and the printer, the only folder that knows yaml-cpp; the readers of JSON and TOML.
  [config/yaml]='batch config/keys'
  # Forms of keys: names, ranges, defaults, and which of them exclude each other.
  [config/keys]='model'
  # Readers of rotors, stops, files of ROSS, matrices and tables.
  [config/machine]='config/keys config/yaml contact matlab structure table'
  # Readers of kick, grid, response and solver.
  [config/study]='config/machine sweep'
  # Reads and prints whole configurations, every problem with its place.
  [config]='config/study'
  # Texts and tables of maps: map.csv, comparisons, basins and summaries on the terminal.
  [report]='sweep'
  # Results of a sweep on the disk: directories taken up again, shares, chunks in rounds, merging, refined and
  # painted cells, status, verification.
  [map]='config report'
  # The journal of `rubbranch --map`.
  [branch/journal]='branch/families map'
  # The motion on which a cell settled, for `report.html` and for comparisons with recordings.
  [page]='report trace'
)

# reachable FOLDER: FOLDER and everything below it, one per line.
reachable() {
  echo "$1"
  local folder
  for folder in ${below[$1]}; do reachable "$folder"; done
}

broken=0
complain() {
  echo "$1: $2"
  broken=1
}

# place_of FILE: sets `storey` and `folder`, the latter without its storey, of a file below LIB/rubsweep.
place_of() {
  local directory=${1%/*}
  storey=${1%%/*}
  folder=${directory#*/}
  [[ $directory != core ]] || folder=.
}

# check_include FILE:LINE STOREY FOLDER NAME OPENING, the last one " or <
check_include() {
  local place=$1 from_storey=$2 from=$3 name=$4 opening=$5 storey folder
  if [[ $name == yaml-cpp/* && $from != config/yaml ]]; then complain "$place" "only config/yaml/ may include $name"; fi
  if [[ $opening == '"' && ! -f $lib/$name ]]; then
    complain "$place" "there is no $name under $lib"
  elif [[ $name == rubsweep/* ]]; then
    place_of "${name#rubsweep/}"
    if [[ " $from_storey ${stands_on[$from_storey]} " != *" $storey "* ]]; then
      complain "$place" "$from_storey does not stand on $name"
    elif [[ $'\n'${allowed[$from]}$'\n' != *$'\n'"$folder"$'\n'* ]]; then
      complain "$place" "$from may not include $name"
    fi
  fi
}

declare -A allowed=()
while IFS= read -r file; do
  place_of "${file#"$lib"/rubsweep/}"
  if [[ -z ${stands_on[$storey]+known} ]]; then
    complain "$file" "$storey is no storey"
    continue
  fi
  if [[ -z ${below[$folder]+known} ]]; then
    complain "$file" "folder $folder has no place in the layers"
    continue
  fi
  [[ -n ${allowed[$folder]+known} ]] || allowed[$folder]=$(reachable "$folder")
  while IFS=: read -r line text; do
    [[ $text =~ ([<\"])([^>\"]+) ]]
    check_include "$file:$line" "$storey" "$folder" "${BASH_REMATCH[2]}" "${BASH_REMATCH[1]}"
  done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]' "$file" || true)
done < <(find "$lib/rubsweep" -name '*.hpp' -o -name '*.cpp' | sort)

exit "$broken"
