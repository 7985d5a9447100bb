#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: hard_dynamics.sh PROGRAM PRM_FOLDER
#
# Hard cases of motion and what "survived" means for each.
scenes=$(realpath "$2")
source "$(dirname "$0")/expect.sh"

# scene NAME ARGUMENT...: it runs to its end, nothing that is not a number, the balance closes.
scene() {
  local name=$1
  shift
  expect 0 'done in' "$scenes/$name.prm" --output "$(basename "$name")" "$@"
  grep -qi 'inf' <(tail -n +2 "$(basename "$name")/timeseries.csv") && failed "$name: infinite"
  tail -n +3 "$(basename "$name")/timeseries.csv" | cut -d, -f1-19 | grep -q nan && failed "$name: NaN"
  expect_between "$(basename "$name")" largest_balance_error 0 1e-5
}

# largest RUN COLUMN: largest absolute value in the time series.
largest() {
  awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ "^" c " ") k = i; next }
    { v = $k < 0 ? -$k : $k; if (v > m) m = v } END { print m + 0 }' "$1/timeseries.csv"
}

# Fast impact, momentum 10 of each sheet: back to where they came from, energy kept.
scene hard/shell/impact
expect_between impact lower_uz -10 0
expect_between impact upper_uz 0 10
expect_between impact largest_energy_drift 0 0.01
awk -v p="$(largest impact momentum_z)" 'BEGIN { exit !(p < 1e-9) }' || failed "impact: momentum"

# Edge to edge: they touch, turn back, and gain no energy.
scene hard/shell/edge-to-edge
expect_between edge-to-edge left_ux -1 0
expect_between edge-to-edge right_ux -0.15 1
expect_between edge-to-edge numerically_lost 0 60
awk -v c="$(largest edge-to-edge contact_energy)" -v p="$(largest edge-to-edge momentum_x)" \
  'BEGIN { exit !(c > 10 && p < 1e-9) }' || failed "edge-to-edge: contact or momentum"

# Long steps: the times of short ones, and shut in the end.
scene hard/shell/ten-times-the-step
expect_between ten-times-the-step fully_open 0.0248 0.0288
expect_between ten-times-the-step closed 0.239 0.243
expect_between ten-times-the-step final_orifice_area 0 1e-3

# A step that cannot be made short enough ends with code 2, its time and the last good state.
expect 2 'last good state' "$scenes/hard/shell/impact.prm" --output given_up \
  --set Solver/Iterations=1 --set "Time/Smallest step=5e-4"
[[ -e given_up/timeseries.csv && ! -e given_up/summary.json ]] || failed "given_up: files"

# A plate vibrates as theory says, and the drift of a free flight stays at the solver's tolerance.
scene benchmarks/shell/plate-vibration
expect_between plate-vibration middle_uz 3.72e-5 3.76e-5
scene benchmarks/shell/free-flight --set "Time/End time=0.9"
expect_between free-flight largest_energy_drift 0 1e-9
finish
