#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: restart.sh PROGRAM PRM_FOLDER
#
# A run that is stopped and goes on from a checkpoint ends bit for bit as one that was not: after an
# interrupt, and after being killed so that files are ahead of the checkpoint.
scenes=$(realpath "$2")
source "$(dirname "$0")/expect.sh"

# The opening valve, with contact at its commissures.
arguments=("$scenes/valve/structural-cycle.prm" --set "Valve/Elements along=8"
  --set "Valve/Elements across=8" --set "Time/End time=0.02" --set "Time/Step=1e-3"
  --set "Output/Series interval=0" --set "Output/VTU interval=5e-3")

same_files() {
  local file
  for file in timeseries.csv profile.csv free_edge.csv shell-0004.vtu; do
    cmp -s "whole/$file" "$1/$file" || failed "$1 differs in $file"
  done
  # the collection holds the date
  cmp -s <(grep DataSet whole/shell.pvd) <(grep DataSet "$1/shell.pvd") ||
    failed "$1 differs in shell.pvd"
  cmp -s <(quantities whole) <(quantities "$1") || failed "$1 differs in its quantities"
}

expect 0 'done in' "${arguments[@]}" --output whole
[[ -e whole/checkpoint-0 ]] && failed "a checkpoint that nobody asked for"

# Interrupted: the run writes a checkpoint and ends with code 2.
rm -f out # of the run before
"$program" "${arguments[@]}" --output interrupted >out 2>err &
pid=$!
until grep -q 'step 12' out 2>/dev/null || ! kill -0 $pid 2>/dev/null; do sleep 0.05; done
kill -TERM $pid
wait $pid
code=$?
[[ $code -eq 2 ]] || failed "interrupted: ends with $code"
grep -q 'restart' err || failed "the message does not say how to go on"
[[ -e interrupted/summary.json ]] && failed "interrupted: has a summary"
expect 0 'going on from step' "${arguments[@]}" --output interrupted --restart
same_files interrupted

# Killed: rows that came after the checkpoint are removed, and written again.
checkpoints=(--set "Checkpoints/Step interval=10")
rm -f out
"$program" "${arguments[@]}" "${checkpoints[@]}" --output killed >out 2>err &
pid=$!
until grep -q 'step 27' out 2>/dev/null || ! kill -0 $pid 2>/dev/null; do sleep 0.05; done
kill -KILL $pid
wait $pid 2>/dev/null
[[ -e killed/checkpoint-0/manifest.txt && -e killed/checkpoint-1/manifest.txt ]] ||
  failed "killed: there are not two checkpoints"
# of two checkpoints the newer one is damaged: the older one does
newest=0
[[ $(sed -n 3p killed/checkpoint-1/manifest.txt | cut -d' ' -f1) -gt \
  $(sed -n 3p killed/checkpoint-0/manifest.txt | cut -d' ' -f1) ]] && newest=1
printf x | dd of=killed/checkpoint-$newest/motion bs=1 seek=200 conv=notrunc 2>/dev/null
expect 0 'going on from step' "${arguments[@]}" --output killed --restart
same_files killed

# What does not fit.
expect 1 'the scene has a shell of 72 elements' "${arguments[@]/across=8/across=9}" \
  --output killed --restart
expect 1 'holds no checkpoint' "${arguments[@]}" --output whole --restart
expect 1 'write no checkpoints' "$scenes/valve/closure.prm" --output whole --restart
expect 1 'leave out --dry-run' "${arguments[@]}" --restart --dry-run
finish
