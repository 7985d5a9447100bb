#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: fsi_benchmarks.sh PROGRAM PRM_FOLDER MPIEXEC
#
# Elastic walls around blood against exact and published values: waves and a pulse in a tube, a
# piston on springs that drives a heavy fluid, a ring in fluid on two ranks.
scenes=$(realpath "$2")/benchmarks/fsi
mpiexec=$3
source "$(dirname "$0")/expect.sh"
export DEAL_II_NUM_THREADS=1

# Exact: 25.0361; within 0.3 %.
expect 0 'done in' "$scenes/wave-speed.prm" --output wave
expect_between wave frequency_A_dx 24.961 25.111

# Published: 0.015851 cm after 7.252 ms, -0.008571 cm along the axis before; within 1 %, 1 % and 3 %.
expect 0 'done in' "$scenes/elastic-tube.prm" --set Mesh/Pipe/Layers=2 --set Time/End=0.008 --output tube
expect_between tube max_A_dx 0.015692 0.016010
expect_between tube time_of_max_A_dx 7.179e-3 7.325e-3
expect_between tube min_A_dz -0.008828 -0.008314

# piston DENSITY FREQUENCY: masses of piston and fluid from 10 to 0.01; within 0.4 %.
piston() {
  expect 0 'done in' "$scenes/spring-piston.prm" --set "Wall/Density=$1" --output "piston-$1"
  expect_between "piston-$1" frequency_A_dx "$(awk -v f="$2" 'BEGIN { print 0.996 * f }')" \
    "$(awk -v f="$2" 'BEGIN { print 1.004 * f }')"
}
piston 50 0.4798702
piston 5 1.1253942
piston 0.5 1.5174775
piston 0.05 1.5836444

# One answer on one and on two ranks.
ring=("$scenes/ring.prm" --set Time/End=1 --set "Levels/References=" --set Output/Peaks=A_dx)
expect 0 'done in' "${ring[@]}" --output ring
on_ranks 2
expect 0 'done in' "${ring[@]}" --output ring-two
on_ranks 1
value=$(quantity ring max_A_dx)
expect_between ring-two max_A_dx "$(awk -v v="$value" 'BEGIN { print 0.9999 * v }')" \
  "$(awk -v v="$value" 'BEGIN { print 1.0001 * v }')"
finish
