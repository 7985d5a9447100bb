#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: fsi_restart.sh PROGRAM PRM_FOLDER MPIEXEC
#
# A valve in flowing blood that is interrupted, or killed, goes on from its checkpoint bit for bit as
# one that was not, on one rank and on two; on another number of ranks to the tolerance of the solver.
scenes=$(realpath "$2")
mpiexec=$3
source "$(dirname "$0")/expect.sh"
export DEAL_II_NUM_THREADS=1

n_steps=12
arguments=("$scenes/fsi-rigid.prm" --set "Valve/Elements along=8" --set "Valve/Elements across=8"
  --set "Mesh/Artery/Cells around=12" --set "Time/Step=1e-3" --set "Time/End=0.012"
  --set "Flow/Linear tolerance=1e-6" --set "Output/Series interval=0"
  --set "Output/Leaflets/Interval=0.004"
  --set "Output/Blood/Interval=0.004")

# same_files A B: two runs left the same behind.
same_files() {
  local file
  # a comment of the blood's files holds the date
  for file in "$1"/*.csv "$1"/*.vtu; do
    cmp -s <(grep -av generated "$file") <(grep -av generated "$2/$(basename "$file")") ||
      failed "$2 differs from $1 in $(basename "$file")"
  done
  # as do the collections
  for file in shell.pvd flow.pvd wall.pvd; do
    cmp -s <(grep DataSet "$1/$file") <(grep DataSet "$2/$file") || failed "$2 differs in $file"
  done
  cmp -s <(quantities "$1") <(quantities "$2") || failed "$2 differs from $1 in its quantities"
}

# until_step N PID: wait.
until_step() {
  until grep -q "step $1," out 2>/dev/null || ! kill -0 "$2" 2>/dev/null; do sleep 0.02; done
}

for ranks in 1 2; do
  on_ranks $ranks
  # checkpoints of steps make the run forget, as one does that goes on from there
  checkpoints=(--set "Checkpoints/Step interval=5")
  expect 0 "step $n_steps," "${arguments[@]}" "${checkpoints[@]}" --output whole-$ranks
  [[ $(wc -l <whole-$ranks/timeseries.csv) -eq $((n_steps + 2)) ]] || failed "rows"
  rm -rf killed-$ranks
  cp -r whole-$ranks killed-$ranks # killed in its last step: files are ahead of the checkpoint
  rm killed-$ranks/summary.json
  expect 0 'going on from step 10' "${arguments[@]}" "${checkpoints[@]}" --output killed-$ranks --restart
  same_files whole-$ranks killed-$ranks
done
on_ranks 1

# The newest checkpoint is damaged: the one before does.
cp -r whole-1 damaged
printf x | dd of=damaged/checkpoint-1/structure bs=1 seek=200 conv=notrunc 2>/dev/null
expect 0 'going on from step 5' "${arguments[@]}" "${checkpoints[@]}" --output damaged --restart
same_files whole-1 damaged

# On another number of ranks: the same to the tolerance of the linear solver.
cp -r whole-2 fewer
expect 0 'going on from step 10' "${arguments[@]}" --output fewer --restart
for name in peak_flow_rate max_mipe_over_time largest_pressure_difference; do
  value=$(quantity whole-2 $name)
  expect_between fewer $name "$(awk -v v="$value" 'BEGIN { print 0.99999 * v }')" \
    "$(awk -v v="$value" 'BEGIN { print 1.00001 * v }')"
done

# Interrupted: the run writes a checkpoint and ends with code 2.
rm -f out
"$program" "${arguments[@]}" --output interrupted >out 2>err &
pid=$!
until_step 3 $pid
kill -TERM $pid
wait $pid
code=$?
[[ $code -eq 2 ]] || failed "interrupted: ends with $code"
grep -q 'restart' err || failed "the message does not say how to go on"
[[ -e interrupted/summary.json ]] && failed "interrupted: has a summary"
[[ -s interrupted/checkpoint-0/manifest.txt ]] || failed "interrupted: no checkpoint"
expect 0 'going on from step' "${arguments[@]}" --output interrupted --restart

expect 1 'the scene has a valve of 216 elements' "${arguments[@]/across=8/across=9}" \
  --output interrupted --restart

# The same with a mesh that follows the leaflets, and elements that get more points.
on_ranks 2
arguments+=(--set "Refinement/Levels=1" --set "Refinement/Width=0.5"
  --set "Boundary conditions/Pressure table/Values=0: 80, 0.004: 150"
  --set "Boundary conditions/Pressure table/Periodic=false")
arguments=("${arguments[@]/End=0.012/End=0.0095}")
checkpoints=(--set "Checkpoints/Step interval=4")
expect 0 'the mesh has followed' "${arguments[@]}" "${checkpoints[@]}" --output whole-follow
cp -r whole-follow killed-follow
expect 0 'the mesh has followed' "${arguments[@]}" "${checkpoints[@]}" --output killed-follow --restart
same_files whole-follow killed-follow
on_ranks 1

finish
