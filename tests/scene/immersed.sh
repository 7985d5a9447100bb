#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: immersed.sh PROGRAM PRM_FOLDER MPIEXEC
#
# Shells and rigid surfaces in a flow against exact solutions: a closed wall, a plate on springs at
# three ratios of masses, a plate along the flow, a manufactured solution with observed orders; one
# answer on one and two ranks; and what they say to wrong input.
scenes=$(realpath "$2")/benchmarks/immersed
mpiexec=$3
source "$(dirname "$0")/expect.sh"

# The first step of the recursion: dP / (rho L/dt + beta) = 2.38095 cm/s through 0.25 cm^2.
expect 0 'done in' "$scenes/closed-barrier.prm" --set Time/End=1e-4 --output barrier
expect_between barrier flow_rate_right 0.5952 0.6012

# A third of a period, from light to heavy fluid: omega = sqrt(k/(rho_s h + rho L)).
plate() { # NAME DENSITY END STEP
  expect 0 'done in' "$scenes/spring-plate.prm" --set "Mesh/Box/Cells=16, 2, 2" \
    --set "Shell/Density=$2" --set "Constants=L: 4, ms: $(awk "BEGIN { print 0.04 * $2 }"), k: 1e4, A: 0.001" \
    --set Time/End="$3" --set Time/Step="$4" --output "$1"
  expect_between "$1" largest_power_imbalance 0 1e-8
}
# balance RUN NAME COLUMN BOUND EXPRESSION: in all rows the column is that expression of the columns $c["..."], of the time step
# dt and of the flow's rate of change dQ, up to that bound relative to the largest value.
balance() {
  awk -F, -v column="$3" -v bound="$4" 'NR == 1 { for (i = 1; i <= NF; ++i) { split($i, name, " "); c[name[1]] = i } next }
    { dt = $c["time_step"]; Q = c["flow_rate_right"] ? $c["flow_rate_right"] : 0
      dQ = NR == 2 ? Q / dt : (1.5 * Q - 2 * Q1 + 0.5 * Q2) / dt; Q2 = Q1; Q1 = Q
      error = '"$5"' - $c[column]; value = $c[column]
      if (error * error > worst * worst) worst = error
      if (value * value > largest * largest) largest = value }
    END { worst /= largest; print "'"$1: $2"': " worst; exit !(NR > 10 && worst * worst < bound * bound) }' "$1/timeseries.csv" ||
    failed "$1: $2"
}

plate heavy 100 0.06 1e-3
expect_between heavy displacement_error_l2 0 6e-6 # of 5e-4
balance heavy 'force of the springs' force_on_supports_x 1e-6 '0.25e4 * $c["plate_ux"]'
plate even 10 0.04 1e-3
expect_between even displacement_error_l2 0 1e-5
plate light 0.1 0.04 1e-3
expect_between light displacement_error_l2 0 1e-5
balance light 'force of the springs' force_on_supports_x 1e-6 '0.25e4 * $c["plate_ux"]'
on_ranks 2
plate light-two 0.1 0.02 1e-3
balance light-two 'force of the springs' force_on_supports_x 1e-6 '0.25e4 * $c["plate_ux"]'
on_ranks 1

# A plate whose edges are held, under pressure: it bears what does not accelerate the blood (1 g), its supports the
# same but for its own inertia (0.1 g).
expect 0 'done in' "$scenes/spring-plate.prm" --set "Mesh/Box/Cells=16, 4, 4" --set Time/End=0.3 --set Time/Step=0.02 \
  --set Shell/Foundation=0 --set "Shell/Saint Venant-Kirchhoff/Young modulus=1e6" --set Flow/Backflow=0 \
  --set "Supports/Supports=pin left; pin right; pin bottom; pin top" --set "Boundary conditions/Tractions=" \
  --set "Boundary conditions/Types=left: pressure; right: pressure; bottom: slip; top: slip; back: slip; front: slip" \
  --set "Boundary conditions/Pressures=left: 10; right: 0" --set "Exact solution/Velocity=" --set "Levels/References=" \
  --set "Exact solution/Displacement=" --set "Exact solution/Shell velocity=" --output held
balance held 'momentum of the blood' force_on_surface_x 1e-4 '2.5 - 4 * dQ'
balance held 'force on the supports' force_on_supports_x 0.01 '2.5 - 4 * dQ'

expect 0 'done in' "$scenes/midline-plate.prm" --output midline
expect_between midline plate_ux 0.2 0.26 # exact 0.235; cells of 1/5
expect_between midline velocity_error_l2 0 0.08

expect 0 '' "$scenes/manufactured.prm" --levels 2 --quiet --output manufactured
expect_between manufactured velocity_error_l2 0 7e-4 # / sqrt(0.1): per depth
expect_between manufactured displacement_error_l2 0 2.7e-4

"$mpiexec" -n 2 "$program" "$scenes/manufactured.prm" --quiet --output ranks || failed "two ranks"
for name in velocity_error_l2 displacement_error_l2 pressure_error_l2; do
  a=$(quantity manufactured/level-0 $name) b=$(quantity ranks $name)
  awk -v a="$a" -v b="$b" 'BEGIN { d = (a - b) / a; exit !(d < 1e-4 && d > -1e-4) }' ||
    failed "$name: $a on one rank, $b on two"
done

# Goes on from a checkpoint bit for bit, moving or rigid, on a mesh that adapts itself or not.
goes_on() { # SCENE ARGUMENT...
  local arguments=("$scenes/$1.prm" "${@:2}" --set "Checkpoints/Step interval=4")
  expect 0 'done in' "${arguments[@]}" --output "whole-$1"
  cp -r "whole-$1" "killed-$1"
  rm "killed-$1/summary.json"
  expect 0 'going on from step' "${arguments[@]}" --output "killed-$1" --restart
  cmp -s "whole-$1/timeseries.csv" "killed-$1/timeseries.csv" || failed "$1 goes on otherwise"
  cmp -s <(quantities "whole-$1") <(quantities "killed-$1") || failed "$1 ends otherwise"
}
goes_on spring-plate --set "Mesh/Box/Cells=16, 2, 2" --set Time/End=0.013 --set Time/Step=1e-3 \
  --set Output/Interval=5e-3
goes_on closed-disk --set "Mesh/Pipe/Cells along=8" --set Time/End=3e-3 \
  --set Mesh/Adaptivity/Interval=3 --set "Mesh/Adaptivity/Largest number of cells=600"
expect 1 'a surface of 16 elements' "$scenes/spring-plate.prm" --set "Mesh/Box/Cells=16, 2, 2" \
  --set "Surface/Elements=3, 3" --set "Checkpoints/Step interval=4" --output whole-spring-plate --restart

expect 1 'a surface is in space' "$scenes/spring-plate.prm" --set Dimension=2
expect 1 'Surface: it lies outside of the mesh' "$scenes/closed-barrier.prm" \
  --set "Surface/Quadrilateral/Corners=9, 0, 0; 9, 1, 0; 9, 0, 1; 9, 1, 1"
expect 1 'displacement and velocity belong together' "$scenes/spring-plate.prm" --set "Exact solution/Shell velocity="
finish
