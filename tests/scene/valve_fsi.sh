#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: valve_fsi.sh PROGRAM PRM_FOLDER MPIEXEC
#
# A valve in flowing blood on the coarsest of meshes: it begins to open, what one gains the other
# loses, and one rank gives what two give.
scenes=$(realpath "$2")
mpiexec=$3
source "$(dirname "$0")/expect.sh"
export DEAL_II_NUM_THREADS=1

# valve RUN OPTION...: 8 steps with few cells.
valve() {
  local run=$1
  shift
  expect 0 'step 8, ' "$scenes/fsi-rigid.prm" --output "$run" --set "Valve/Elements along=8" \
    --set "Valve/Elements across=8" --set "Mesh/Artery/Cells around=12" --set "Time/End=0.004" \
    --set "Flow/Linear tolerance=1e-6" "$@"
}

# A dry run tells about the surfaces.
expect 0 'leaflets at most' "$scenes/fsi-rigid.prm" --dry-run --set "Mesh/Artery/Cells around=12"

valve one
expect_between one peak_flow_rate 2.5 4.5
expect_between one largest_power_imbalance 0 1e-8
expect_between one iterations_per_step 1 2
expect_between one rejected_steps 0 0
expect_between one largest_pressure_difference 0.5 3
[[ $(wc -l <one/timeseries.csv) -eq 6 ]] || failed "rows of the time series"
for file in one/shell.pvd one/flow.pvd one/wall.pvd one/profile.csv one/free_edge.csv; do
  [[ -s $file ]] || failed "there is no $file"
done

# In turns, fluid and shell come to the same motion.
valve block --set "Coupling/Scheme=block" --set "Coupling/Tolerance=1e-4" \
  --set "Coupling/Iterations=60"
for name in peak_flow_rate max_mipe_over_time largest_pressure_difference; do
  value=$(quantity one $name)
  expect_between block $name "$(awk -v v="$value" 'BEGIN { print 0.998 * v }')" \
    "$(awk -v v="$value" 'BEGIN { print 1.002 * v }')"
done

# In an elastic artery, what flows in and not out is stored.
expect 0 'step 8, ' "$scenes/fsi.prm" --output elastic --set "Valve/Elements along=8" \
  --set "Valve/Elements across=8" --set "Mesh/Artery/Cells around=12" --set "Time/End=0.004"
expect_between elastic largest_volume_error 0 0.01 # of 90
expect_between elastic largest_power_imbalance 0 1e-8
expect_between elastic rejected_steps 0 0

on_ranks 2
valve two
on_ranks 1
for name in peak_flow_rate max_mipe_over_time largest_pressure_difference; do
  value=$(quantity one $name)
  expect_between two $name "$(awk -v v="$value" 'BEGIN { print 0.9999 * v }')" \
    "$(awk -v v="$value" 'BEGIN { print 1.0001 * v }')"
done

expect 0 'nothing was written' "$scenes/fsi-rigid.prm" --dry-run
expect 1 'blood needs all leaflets' "$scenes/fsi-rigid.prm" --dry-run --set "Valve/Modelled leaflets=one"
expect 1 'outside of the artery' "$scenes/fsi-rigid.prm" --dry-run --set "Mesh/Artery/Radius=1.0"

finish
