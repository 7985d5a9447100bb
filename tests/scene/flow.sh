#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: flow.sh PROGRAM PRM_FOLDER MPIEXEC
#
# Flow scenes: orders of convergence at rest and on a moving mesh, free stream, drag of a cylinder,
# wall shear stress and flow balance in a pipe, one answer on one and two ranks, and what they say to
# wrong input.
scenes=$(realpath "$2")/benchmarks/flow
mpiexec=$3
source "$(dirname "$0")/expect.sh"

# order RUN QUANTITY LOW: the observed order of the finest level is at least this.
order() {
  local value
  value=$(awk -F, -v q="$2" '$1 == q { order = $8 } END { print order }' "$1/speed_vs_error.csv")
  echo "$1: order of $2: $value"
  awk -v v="$value" -v l="$3" 'BEGIN { exit !(v != "" && v + 0 >= l) }' ||
    failed "$1: order of $2 is '$value', below $3"
}

for scene in manufactured-2d manufactured-moving-2d; do
  expect 0 '' "$scenes/$scene.prm" --levels 3 --quiet --output $scene
  order $scene velocity_error_l2 2.9
  order $scene velocity_error_h1 1.9
  order $scene pressure_error_l2 1.9
done

for scene in taylor-green beltrami; do
  expect 0 '' "$scenes/$scene.prm" --levels 3 --quiet --output $scene
  order $scene velocity_error_l2 2.9
  order $scene velocity_error_h1 1.9
  order $scene pressure_error_l2 1.9
done

expect 0 '' "$scenes/breathing-cylinder.prm" --set Time/End=0.2 --set Time/Step=0.02 --levels 2 \
  --quiet --output breathing-cylinder
order breathing-cylinder velocity_error_l2 2.9
order breathing-cylinder pressure_error_l2 1.9

expect 0 'done in' "$scenes/free-stream.prm" --set Time/End=0.1 --output free-stream
expect_between free-stream velocity_error_max 0 1e-9

expect 0 'done in' "$scenes/piston.prm" --output piston
expect_between piston velocity_error_l2 0 1e-3

# Published: 5.5795, 0.11752.
expect 0 'done in' "$scenes/dfg-2d-1.prm" --set "Time/Steady tolerance=1e-4" --output dfg
expect_between dfg force_cylinder_x 5.5790 5.5800
expect_between dfg dp 0.1172 0.1179

# Published: 6.1853, 0.1710; on the coarsest mesh, before the flow is quite steady.
expect 0 'done in' "$scenes/dfg-3d-1z.prm" --set "Mesh/Cylinder in channel/Cells deep=4" \
  --set Time/End=5.2 --output dfg3
expect_between dfg3 force_cylinder_x 6.124 6.247
expect_between dfg3 force_cylinder_y 0.00846 0.01034
expect_between dfg3 dp 0.1667 0.1753

expect 0 'done in' "$scenes/poiseuille.prm" --set "Time/End=1" --set "Output/Interval=0.5" \
  --output pipe
expect_between pipe wall_shear_stress_min 0.1721 0.1773
expect_between pipe wall_shear_stress_max 0.1721 0.1773
expect_between pipe max_flow_imbalance 0 1e-11
for file in flow-0002.vtu wall-0002.vtu flow.pvd wall.pvd; do
  [[ -s pipe/$file ]] || failed "there is no $file"
done

# Blood that slips along the wall moves as a plug that loses rho u^2 / 2 where it enters (beta = 1/2):
# Torricelli's speed U, and u' = +-(U^2 -+ u^2) / (2 L) while the pressure pushes with and against it.
torricelli=($(awk 'BEGIN {
  p = 40 * 1333.22; L = 8; U = sqrt(2 * p); T = 2 * L / U; Q = 3.141592653589793 * 1.3 ^ 2 * U
  e = exp(2 * 0.06 / T); u = (e - 1) / (e + 1) # relative to U, when the pressure turns
  e = exp(2 * (0.09 / T - atan2(u, 1))); v = (e - 1) / (e + 1)
  print -1.01 * Q * u, -0.99 * Q * u, 0.998 * Q * v, 1.002 * Q * v }'))
expect 0 'done in' "$scenes/impulsive-backflow.prm" --set "Flow/Linear tolerance=1e-8" \
  --set "Mesh/Pipe/Cells around=6" --set "Mesh/Pipe/Cells along=8" --set Time/Step=0.0005 \
  --set "Boundary conditions/Types=inlet: pressure; outlet: pressure; wall: slip" --output plug
expect_between plug min_flow_rate_outlet "${torricelli[0]}" "${torricelli[1]}"
expect_between plug flow_rate_outlet "${torricelli[2]}" "${torricelli[3]}"
expect_between plug max_flow_imbalance 0 1e-11

# An elastic flag (FSI1): within 1 % of 0.0227049e-3, 0.820877e-3, 14.29426, 0.763746.
expect 0 'done in' "$scenes/../fsi/fsi1.prm" --set Time/Step=0.05 \
  --set "Time/Steady tolerance=1e-4" --output flag
expect_between flag A_dx 2.2478e-5 2.2932e-5
expect_between flag A_dy 8.127e-4 8.291e-4
expect_between flag force_with_wall_x 14.151 14.438
expect_between flag force_with_wall_y 0.7561 0.7714

# Its solid alone under gravity (CSM1): within 0.5 % of -7.18767e-3, -66.1023e-3.
fsi=$scenes/../fsi
expect 0 'done in' "$fsi/csm1.prm" --output solid
expect_between solid A_dx -7.2236e-3 -7.1517e-3
expect_between solid A_dy -6.6433e-2 -6.5772e-2

# A ring in fluid, exact frequency 1.804513172 / (2 pi), within 0.2 %.
expect 0 'done in' "$fsi/ring.prm" --output ring
expect_between ring frequency_A_dx 0.28662 0.28777

# A massless wall: the published lowest position is -0.21600, at 0.46875. Within 0.5 %.
expect 0 'done in' "$fsi/collapsible-channel.prm" --set Time/End=0.5 --output collapsible
expect_between collapsible min_M_dy -0.21708 -0.21492
expect_between collapsible time_of_min_M_dy 0.4664 0.4711

# One answer on one and on two ranks.
"$mpiexec" -n 2 "$program" "$scenes/poiseuille.prm" --set Time/End=1 --quiet --output ranks ||
  failed "two ranks"
for name in pressure_inlet flow_rate_z0 wall_shear_stress_max; do
  a=$(quantity pipe $name) b=$(quantity ranks $name)
  awk -v a="$a" -v b="$b" 'BEGIN { d = (a - b) / a; exit !(d < 1e-6 && d > -1e-6) }' ||
    failed "$name: $a on one rank, $b on two"
done

# A run that is killed goes on from its checkpoint, bit for bit as one that was not.
arguments=("$scenes/impulsive-backflow.prm" --set Time/End=0.012 --set Output/Interval=0.004
  --set "Checkpoints/Step interval=4")
expect 0 'done in' "${arguments[@]}" --output whole
rm -f out # of the run before
"$program" "${arguments[@]}" --output killed >out 2>err &
pid=$!
until grep -q 'step 7,' out 2>/dev/null || ! kill -0 $pid 2>/dev/null; do sleep 0.05; done
kill -KILL $pid
wait $pid 2>/dev/null
expect 0 'going on from step' "${arguments[@]}" --output killed --restart
cmp whole/timeseries.csv killed/timeseries.csv || failed "the restarted run differs"

# The mesh follows the flow.
expect 0 'done in' "$scenes/dfg-2d-3.prm" --set Mesh/Refinements=1 --set Time/End=0.2 \
  --set Time/Step=0.01 --set Flow/Degree=2 --set "Mesh/Adaptivity/Interval=5" --output adapted
expect_between adapted cells 500 2000
expect_between adapted flow_imbalance 0 1e-11

# Wrong input.
expect 1 "no such column" "$fsi/csm1.prm" --set "Output/Oscillations=A_dz" --dry-run
cavity=$scenes/cavity.prm
types="left: wall; right: wall; bottom: wall"
expect 1 "boundary 'top' has no type" "$cavity" --set "Boundary conditions/Types=$types" --dry-run
expect 1 "did you mean 'top'" "$cavity" --set "Boundary conditions/Types=$types; tob: wall" --dry-run
expect 1 "no such type" "$cavity" --set "Boundary conditions/Types=$types; top: wal" --dry-run
expect 1 "is not in it" "$cavity" --set "Boundary conditions/Velocities=" --dry-run
expect 1 "no expression" "$cavity" --set "Boundary conditions/Velocities=top: (1, 2*)" --dry-run
expect 1 "2 components" "$cavity" --set "Boundary conditions/Velocities=top: (1, 0, 0)" --dry-run
expect 1 "no exact solution" "$cavity" --set "Boundary conditions/Types=$types; top: exact" --dry-run
expect 1 "does not lie in the mesh" "$cavity" --set "Output/Probes=a: (2, 0)" --dry-run
expect 1 "no such column" "$cavity" --set "Output/Peaks=drag" --dry-run
expect 1 "three dimensions" "$cavity" --set Mesh/Shape=artery --dry-run
expect 1 "two dimensions" "$scenes/../fsi/fsi1.prm" --set Dimension=3 --dry-run
finish
