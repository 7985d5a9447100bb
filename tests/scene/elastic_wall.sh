#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: elastic_wall.sh PROGRAM PRM_FOLDER MPIEXEC
#
# Elastic arteries in scenes: a wall that a prestress keeps where it is, meshes that are finer around
# the valve, on one and two ranks; steps that are cut before cells turn over; and what a section Wall
# without a wall says.
scenes=$(realpath "$2")
mpiexec=$3
source "$(dirname "$0")/expect.sh"
export DEAL_II_NUM_THREADS=1

# same RUN RUN QUANTITY SHARE: they differ by no more than this share.
same() {
  local value
  value=$(quantity "$1" "$3")
  expect_between "$2" "$3" "$(awk -v v="$value" -v s="$4" 'BEGIN { print v - s * (v < 0 ? -v : v) }')" \
    "$(awk -v v="$value" -v s="$4" 'BEGIN { print v + s * (v < 0 ? -v : v) }')"
}

base=$scenes/hard/artery/base.prm

# In balance with 80 mmHg everywhere, nothing moves; a linear wall would by 0.1 cm.
still=("Boundary conditions/Pressures=inlet: 80*mmHg; outlet: 80*mmHg" "Time/End=2e-3")
for ranks in 1 2; do
  on_ranks $ranks
  expect 0 'done in' "$base" --set "${still[0]}" --set "${still[1]}" --output still-$ranks
  expect_between still-$ranks max_largest_wall_displacement 0 2e-5
done
on_ranks 1

# Finer around the valve, wall and all.
finer=(--set "Mesh/Box refinements=1" --set "Mesh/Boxes=-2.5, -2.5, 0, 2.5, 2.5, 2" --set Time/End=2e-3
  --set "Flow/Linear tolerance=1e-7")
expect 0 'done in' "$base" "${finer[@]}" --output finer
expect_between finer cells 2000 5000
expect_between finer largest_volume_error 0 0.01
on_ranks 2
expect 0 'done in' "$base" "${finer[@]}" --output finer-two
on_ranks 1
same finer finer-two lumen_volume 1e-6
same finer finer-two max_largest_wall_displacement 1e-3

# goes_on RUN STEP ARGUMENT...: killed in its last step, after a checkpoint at this one, it goes on bit for bit.
goes_on() {
  local run=$1 step=$2
  shift 2
  cp -r "$run" "killed-$run"
  expect 0 "going on from step $step" "$@" --output "killed-$run" --restart
  cmp "$run/timeseries.csv" "killed-$run/timeseries.csv" || failed "$run: differs after a restart"
  cmp <(quantities "$run") <(quantities "killed-$run") || failed "$run: quantities after a restart"
}

# A mesh that changes under way, by the flow and by the leaflets.
adapted=("$base" --set Time/End=4e-3 --set Mesh/Adaptivity/Interval=2 --set "Checkpoints/Step interval=3")
on_ranks 2
expect 0 'done in' "${adapted[@]}" --output adapted
expect_between adapted cells 1000 3000
goes_on adapted 3 "${adapted[@]}"
on_ranks 1

valve=("$scenes/valve/fsi.prm" --set "Valve/Elements along=8"
  --set "Valve/Elements across=8" --set "Mesh/Artery/Cells around=12" --set Time/End=2e-3
  --set Refinement/Levels=1 --set Refinement/Width=1 --set Refinement/Interval=2
  --set "Checkpoints/Step interval=3")
expect 0 'done in' "${valve[@]}" --output valve
expect_between valve cells 2000 4000
expect_between valve rejected_steps 0 0
expect_between valve largest_volume_error 0 0.002 # of 90
goes_on valve 3 "${valve[@]}"

expect 1 'the probe does not lie in the wall' "$base" --set "Output/Wall probes=far: (9, 0, 1)" --dry-run

# A section Wall without a wall.
rigid=$scenes/flow/artery.prm
expect 1 'no wall that this describes' "$rigid" --dry-run --set Wall/Density=2
expect 0 'section Wall describes nothing' "$rigid" --dry-run --set Wall/Density=1
expect 1 'no boundary of this name' "$base" --dry-run --set "Wall/Support stiffness=1" \
  --set "Wall/Supported boundaries=outer"
expect 1 'no cell of the wall lies' "$base" --dry-run --set "Wall/Support stiffness=1" \
  --set "Wall/Supported boundaries=inlet"
finish
