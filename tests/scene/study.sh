#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: study.sh PROGRAM PRM_FOLDER
#
# --study: a table of runs with one entry changed at a time, failures included; wrong variations.
scene=$(realpath "$2")/benchmarks/shell/cantilever.prm
source "$(dirname "$0")/expect.sh"

small=("$scene" --set "Surface/Elements=4, 1" --set "Study/Quantities=strain_energy")
expect 0 'done in' "${small[@]}" --study --output plate \
  --set "Study/Variations=Shell/Thickness: 0.1 | 0.2; Solver/Iterations: 1"
[[ $(wc -l < plate/study.csv) -eq 5 ]] || failed "study.csv has not five lines"
grep -q '^run-01,"Shell/Thickness","0.1",.*,""$' plate/study.csv || failed "no row of run-01"
[[ -s plate/study.svg && -s plate/run-03/parameters.prm ]] || failed "files are missing"

expect 1 'there is no such entry' "${small[@]}" --study --set "Study/Variations=Shell/Thicknes: 1"
expect 1 'this changes no entry' "${small[@]}" --study --set "Study/Variations=Shell"
expect 1 'what to vary' "${small[@]}" --study
expect 1 'do not go together' "${small[@]}" --study --levels 2
finish
