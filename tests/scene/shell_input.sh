#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: shell_input.sh PROGRAM
#
# What the scenes of shells say to input that is wrong, and to a load that is too much.
source "$(dirname "$0")/expect.sh"

cat >strip.prm <<'END_PRM'
set Scene = shell statics
subsection Surface
  set Source   = quadrilateral
  set Degree   = 2
  set Elements = 4, 2
end
subsection Supports
  set Supports = clamp x=0
end
subsection Loads
  set Edge loads = x=1: (0, 0, 10)
end
subsection Solver
  set Method = Newton
end
END_PRM

# wrong ENTRY TEXT SETTING...: with these settings the entry is refused with this text.
wrong() {
  local entry=$1 text=$2 setting arguments=()
  shift 2
  for setting in "$@"; do arguments+=(--set "$setting"); done
  expect 1 "$text" strip.prm --dry-run "${arguments[@]}"
  grep -qF "error: --set, $entry" err || failed "$* is not blamed on $entry"
}

expect 0 'the scene can be built' strip.prm --dry-run

# Sections.
wrong Shell/Thickness '= "-1": the value is not allowed' Shell/Thickness=-1
wrong Shell/Material '= "Fnug": the value is not allowed; give one of' Shell/Material=Fnug
wrong 'Shell/Saint Venant-Kirchhoff/Poisson ratio' '= "0.5": out of range' \
  'Shell/Material=Saint Venant-Kirchhoff' 'Shell/Saint Venant-Kirchhoff/Poisson ratio=0.5'

# A quarter of a cylinder that is thicker than its radius.
wrong Shell/Thickness 'the undeformed surface is bent too tightly for a shell this thick near (' \
  Surface/Source=cylinder Surface/Cylinder/Radius=1 Shell/Thickness=1.5

# supports LIST TEXT: a list of supports is refused with this text.
supports() { wrong Supports/Supports "$2" "Supports/Supports=$1"; }

# What is held must leave no rigid motion.
supports '' 'piece 1 of 1 of the surface can still move rigidly in 6'
supports 'pin x=0' 'can still move rigidly in 1'
supports 'pin (0, 0, 0)' 'can still move rigidly in 3'
supports 'symmetry x=0' 'can still move rigidly in 3'
supports 'clamp left; pin rigth' \
  '"rigth": the surface has no such node set; its node sets are left, right, bottom, top'
supports 'clamp x=2' '"x=2": no control point lies in this plane'
supports 'weld left' '"weld left": this support is not understood; the verbs are: fix'
supports 'symmetry x=0 y' '"x=0 y": a plane has its own normal; write symmetry x=0'
supports 'clamp' '"clamp": this support is not understood'
supports 'clamp left; fix right xw' '"xw": these are not components'

# Loads, probes, methods.
wrong Loads/Pressure 'the pressure is given twice; give either' \
  Loads/Pressure=1 'Loads/Pressure in mmHg=1'
wrong 'Loads/Edge loads' '"x=1 (0, 0, 10)": this is not a load; write PLACE: (fx, fy, fz)' \
  'Loads/Edge loads=x=1 (0, 0, 10)'
wrong 'Loads/Edge loads' '"x=0.5": no control point lies in this plane' \
  'Loads/Edge loads=x=0.5: (0, 0, 10)'
wrong Output/Probes '"tip (1, 0, 0)": this is not a probe; write NAME: (x, y, z)' \
  'Output/Probes=tip (1, 0, 0)'
wrong Output/Probes '"(1, 0)": this is not a vector' 'Output/Probes=tip: (1, 0)'
wrong Solver/Method '= "newton": the value is not allowed; give one of' Solver/Method=newton
expect 1 'contact is not linear' strip.prm --set Solver/Method=linear --set Contact/Enabled=true

wrong 'Solver/Stop at' '"tip_ux 3": this is no displacement; write NAME_ux: VALUE' \
  'Output/Probes=tip: (1, 0, 0)' 'Solver/Stop at=tip_ux 3'
wrong 'Solver/Stop at' \
  '"tip_uz": no probe records this; name a probe and its component: did you mean '\''tipp_uz' \
  'Output/Probes=tipp: (1, 0, 0)' 'Solver/Stop at=tip_uz: 3'
supports 'clamp x=0; move left z 0.1' 'is given two different displacements in z: 0 and 0.1'
wrong 'Loads/Edge moments' '"x=1 3": this is not a moment along an edge; write PLACE: M' \
  'Loads/Edge moments=x=1 3'

# Reference curves: deviations by hand from a straight one, and files that are none.
curve() {
  printf 'quantity,load_factor,value,source\n%s\n' "$2" >curve.csv
  expect 1 "$1" strip.prm --dry-run --set 'Output/Probes=tip: (1, 0, 0)' \
    --set 'Output/Reference curve=curve.csv'
}
curve 'curve.csv:2 = "tip_u": the run records no such quantity' 'tip_u,1,2,me'
curve 'curve.csv:2 = "two": this is not a number' 'tip_uz,1,two,me'
curve 'curve.csv:2 = "tip_uz,1,2": a reference needs four fields' 'tip_uz,1,2'
expect 1 'this is no header of a reference curve' strip.prm --dry-run \
  --set 'Output/Reference curve=strip.prm'
expect 1 'cannot be read' strip.prm --dry-run --set 'Output/Reference curve=none.csv'
printf 'quantity,load_factor,value,source\n-tip_uz,%s,me\n-tip_uz,%s,me\n' 0.37,-0.5 1,-2 >curve.csv
expect 0 'load factor 0.37, ' strip.prm --output curve --set 'Loads/Edge loads=x=1: (0, 0, 1e-9)' \
  --set 'Output/Probes=tip: (1, 0, 0)' --set 'Output/Reference curve=curve.csv'
expect_between curve points_compared 2 2
expect_between curve largest_deviation 0.999999 1.000001 # nothing moves, against 2
expect_between curve mean_deviation 0.624999 0.625001

# A displacement that ends the run.
expect 0 '' strip.prm --output stopped --set 'Loads/Edge loads=x=1: (0, 0, 1)' \
  --set 'Output/Probes=tip: (1, 0, 0)' --set 'Solver/Stop at=tip_uz: 0.001'
expect_between stopped tip_uz 0.001 0.1
expect_between stopped load_factor 0 0.9999

# Numerics that give up say how far they came and name a file that is there.
gives_up() {
  expect 2 'at load factor 0.' strip.prm --output "$1" --set "Loads/Edge loads=x=1: ($2)"
  local last
  last=$(sed -n 's/.*the last good state is in \(.*\)$/\1/p' err)
  [[ $last == "$1"/shell-*.vtu && -s $last ]] || failed "no last good state in '$last'"
  grep -qF "\"${last##*/}\"" "$1/shell.pvd" || failed "$last is not in the collection"
  [[ -e $1/summary.json ]] && failed "a run that gave up wrote a summary"
}
gives_up much '0, 0, 1e9'
gives_up at_once '0, 0, 1e30'

finish
