#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: levels.sh PROGRAM
#
# The same scene at several resolutions: entries, errors against a reference and estimated, files.
source "$(dirname "$0")/expect.sh"

cat >roof.prm <<'END_PRM'
set Scene = shell statics
subsection Surface
  set Source   = cylinder
  set Degree   = 3
  set Elements = 3, 4
  subsection Cylinder
    set Radius  = 25
    set Angles  = 50, 90
    set Heights = 0, 25
  end
end
subsection Shell
  set Material  = Saint Venant-Kirchhoff
  set Thickness = 0.25
  subsection Saint Venant-Kirchhoff
    set Young modulus = 4.32e8
    set Poisson ratio = 0
  end
end
subsection Supports
  set Supports = symmetry x=0; symmetry z=0; fix z=25 xy
end
subsection Loads
  set Area load = (0, -90, 0)
end
subsection Solver
  set Method = linear
end
subsection Output
  set Probes = edge: (16.0696902421635, 19.1511110779745, 0)
end
subsection Levels
  set References = edge_uy: -0.300614 (limit of Kirchhoff-Love shells)
  set Quantities = edge_uy, strain_energy
end
END_PRM

# row QUANTITY LEVEL COLUMN: a number of the study.
row() { awk -F, -v q="$1" -v l="$2" -v c="$3" '$1 == q && $3 == l { print $c }' study/speed_vs_error.csv; }
expect_number() {
  awk -v v="$1" -v l="$2" -v h="$3" 'BEGIN { exit !(v != "" && v + 0 >= l && v + 0 <= h) }' ||
    failed "$4: '$1' does not lie between $2 and $3"
}

expect 0 'strain_energy = ' roof.prm --output study --levels 3
[[ $(wc -l <study/speed_vs_error.csv) -eq 7 ]] || failed "rows of other quantities or levels"
grep -q 'set Elements *= 12, 16' study/level-2/parameters.prm || failed "the finest level is another"
[[ $(row edge_uy 0 7) == reference && $(row strain_energy 0 7) == Richardson ]] ||
  failed "the basis of the errors"
expect_number "$(row edge_uy 2 6)" 0 1e-5 "relative error of the deflection"
expect_number "$(row edge_uy 2 8)" 4 9 "order of the deflection"
expect_number "$(row strain_energy 2 8)" 4 9 "order of the energy"
expect_number "$(row strain_energy 0 9)" 70 90 "unknowns"
expect_number "$(quantity study edge_uy)" -0.30062 -0.30061 "deflection in the summary"
grep -q '"edge_uy": {.*"reference": -0.30061.*"error": .*"order": ' study/summary.json ||
  failed "the summary has no errors"
grep -q '"level 2": ' study/summary.json || failed "the summary does not say what a level has cost"
grep -q '<polyline.*points="[0-9]' study/speed_vs_error.svg || failed "the plot is empty"
tail -n 1 study/speed_vs_error.svg | grep -q '</svg>' || failed "the plot is torn"

# The finest level is what a plain run with its entries gives; the summary compares this, too.
expect 0 'done in' roof.prm --output plain --set 'Surface/Elements=12, 16'
[[ $(quantity plain edge_uy) == $(quantity study edge_uy) ]] || failed "a plain run differs"
grep -q '"edge_uy": {.*"reference": -0.30061.*"error": ' plain/summary.json ||
  failed "a plain run is not compared with the reference"
grep -q '"unknowns": [1-9]' plain/summary.json || failed "a plain run has no unknowns"

# A study into the folder of a plain run leaves nothing of it, and the other way round.
expect 0 'level 2 of 2' roof.prm --output plain --levels 2
[[ -e plain/timeseries.csv ]] && failed "the time series of the plain run survives"
expect 0 'done in' roof.prm --output plain
[[ -e plain/speed_vs_error.csv ]] && failed "the study survives"

expect 0 'nothing was written' roof.prm --levels 2 --dry-run --output dry
[[ -e dry ]] && failed "a dry run writes"

expect 1 'did you mean' roof.prm --levels 2 --output x --set 'Levels/Finer=Surface/Element * 2'
expect 1 'this changes no entry' roof.prm --levels 2 --output x --set 'Levels/Finer=Surface/Elements'
expect 1 'this makes nothing finer' roof.prm --levels 2 --output x --set 'Levels/Finer=Surface/Elements * 1'
expect 1 'there are values for 2 levels only' roof.prm --levels 3 --output x --set 'Levels/Finer=Surface/Degree: 3 | 4'
expect 1 'order the values' roof.prm --levels 3 --output x --set 'Levels/Finer=Surface/Degree: 3 | 5 | 4'
expect 1 'this is no resolution' roof.prm --levels 3 --output x --set 'Levels/Finer=Surface/Degree: 3 | fine'
expect 1 'the entry holds no number' roof.prm --levels 2 --output x --set 'Levels/Finer=Surface/Source * 2'
expect 1 'the scene does not say what finer means' roof.prm --levels 2 --output x --set 'Levels/Finer='
expect 1 'level 1, Surface/Degree' roof.prm --levels 2 --output x --set 'Levels/Finer=Surface/Degree * 3'
expect 1 'the run has no such quantity' roof.prm --output x --set 'Levels/References=edge_u: 1'
[[ -e x/summary.json ]] || failed "a mistaken reference loses the run"
expect 1 'this is no reference' roof.prm --output x --set 'Levels/References=edge_uy = 1'
expect 1 'this is no number of levels' roof.prm --levels two
expect 1 'the number of levels is missing' roof.prm --levels

finish
