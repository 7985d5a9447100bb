#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: valve_statics.sh PROGRAM PRM_FOLDER MPIEXEC
#
# The shipped valve scenes on coarse meshes: the figures a valve is judged by, and that they depend
# neither on the number of threads nor on that of ranks, which repeat the same calculation.
scenes=$(realpath "$2")
mpiexec=$3
source "$(dirname "$0")/expect.sh"
export DEAL_II_NUM_THREADS=1
unset OPENBLAS_NUM_THREADS # one, unless the environment asks for more

# valve RUN SCENE N: leaflets of N x N elements.
valve() {
  expect 0 'step 1: load factor 1' "$scenes/$2.prm" --output "$1" \
    --set "Valve/Elements along=$3" --set "Valve/Elements across=$3"
}

# same RUN OTHER: bit for bit.
same() {
  local file
  for file in timeseries.csv shell-0001.vtu; do
    cmp -s "$1/$file" "$2/$file" || failed "$1 and $2 differ in $file"
  done
  cmp -s <(quantities "$1") <(quantities "$2") || failed "$1 and $2 differ in their quantities"
}

# The same for all: three equal leaflets stay equal, penetration is small.
expect_sound() {
  expect_between "$1" rotational_asymmetry 0 1e-6
  expect_between "$1" largest_penetration_of_thickness 0 0.05
  awk -F, 'NR == 2 { good = $1 == 1 && $3 <= 1e-8 } END { exit !good }' "$1/timeseries.csv" ||
    failed "$1: no equilibrium at the full load"
}

# Closed: figures of this mesh, 2 % around those found first; no opening is left.
valve closed closure 10
expect_sound closed
expect_between closed max_mipe 0.265 0.276
expect_between closed coaptation_area 0.348 0.362
expect_between closed orifice_area 0 2e-3

DEAL_II_NUM_THREADS=2 valve closed_by_2_threads closure 10
same closed closed_by_2_threads

on_ranks 2
valve closed_by_2_ranks closure 10
same closed closed_by_2_ranks
on_ranks 1

# One leaflet that stands for all gives their answers with a third of the unknowns.
expect 0 'step 1: load factor 1' "$scenes/closure.prm" --output one_of_three \
  --set "Valve/Elements along=10" --set "Valve/Elements across=10" --set "Valve/Modelled leaflets=one"
for name in max_mipe strain_energy orifice_area coaptation_area coaptation_height largest_penetration; do
  all=$(quantity closed $name)
  margin=$(awk -v v="$all" 'BEGIN { print v < 0 ? -1e-8 * v : 1e-8 * v }')
  expect_between one_of_three $name "$(awk -v v="$all" -v m="$margin" 'BEGIN { printf "%.12g", v - m }')" \
    "$(awk -v v="$all" -v m="$margin" 'BEGIN { printf "%.12g", v + m }')"
done
unknowns() { sed -n 's/.*"unknowns": \([0-9]*\),/\1/p' "$1/summary.json"; }
[[ $((3 * $(unknowns one_of_three))) -eq $(unknowns closed) ]] || failed "another number of unknowns"
[[ $(stat -c %s one_of_three/shell-0001.vtu) -gt $(($(stat -c %s closed/shell-0001.vtu) * 9 / 10)) ]] ||
  failed "the file of one leaflet does not hold all"

# The material that does not stiffen closes as well and strains more (Hsu et al. 2015).
valve closed_svk closure-svk 10
expect_sound closed_svk
expect_between closed_svk orifice_area 0 2e-3
expect_between closed_svk max_mipe "$(awk -v x="$(quantity closed max_mipe)" 'BEGIN { print 1.2 * x }')" 0.7

# Open: most of the 3.92 cm^2 within the stent.
valve open opening 8
expect_sound open
expect_between open orifice_area 1.5 3.9
expect_between open coaptation_area 0 0

# Refined by need: each round has a smaller error on more elements, and another scene takes the mesh.
t_spline=(--set "Valve/Modelled leaflets=one" --set "Valve/Layout=T-spline"
  --set "Valve/T-spline/Elements along=8" --set "Valve/T-spline/Elements across=6"
  --set "Valve/T-spline/Attachment levels=0" --set "Valve/T-spline/Commissure levels=0")
expect 0 'round 2: estimated error' "$scenes/closure.prm" --output adapted "${t_spline[@]}" \
  --set "Adaptivity/Rounds=2"
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^estimated_error/) column = i }
         NR > 1 { good = NR == 2 || ($2 > elements && $column < error); elements = $2; error = $column
                  if (!good) bad = 1 }
         END { exit bad || NR != 4 }' adapted/adaptivity.csv || failed "errors do not fall: adaptivity.csv"
expect_between adapted estimated_error 0.1 0.25
[[ -e adapted/round-1/shell-0001.vtu ]] || failed "the second round has no folder of its own"
elements=$(awk -F, 'END { print $2 }' adapted/adaptivity.csv)
expect 0 "$elements elements" "$scenes/structural-cycle.prm" --dry-run "${t_spline[@]}" \
  --set "Valve/T-spline/Sizes file=adapted/elements.csv"
on_ranks 2
expect 0 'round 1: estimated error' "$scenes/closure.prm" --output adapted_by_2_ranks \
  "${t_spline[@]}" --set "Adaptivity/Rounds=1"
on_ranks 1
cmp -s <(head -n 3 adapted/adaptivity.csv) adapted_by_2_ranks/adaptivity.csv ||
  failed "two ranks refine differently"
expect 1 'Adaptivity/Rounds = "1": only T-splines are refined locally' "$scenes/closure.prm" \
  --output none --set "Adaptivity/Rounds=1"

finish
