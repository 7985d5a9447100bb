#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: shell_benchmarks.sh PROGRAM PRM_FOLDER
#
# The shipped benchmarks of shells, where they are quick: deviations from their references.
scenes=$(realpath "$2")/benchmarks/shell
source "$(dirname "$0")/expect.sh"

# curve SCENE LARGEST POINTS [ARGUMENT...]: all points of the reference curve within this.
curve() {
  local scene=$1 largest=$2 points=$3
  shift 3
  expect 0 'load factor' "$scenes/$scene.prm" --output "$scene" "$@"
  expect_between "$scene" points_compared "$points" "$points"
  expect_between "$scene" largest_deviation 0 "$largest"
}

curve cantilever 5e-5 40
curve cantilever-moment 5e-4 40
curve cylinder-inflation 1e-4 5
curve circular-membrane 1e-5 7
curve balloon 1e-3 19
curve pinched-hemisphere-large 0.02 40 --set Surface/Elements=12,12 --set Surface/Degree=4
curve hinged-roof 0.01 35 --set Surface/Elements=8,8 # 36 points, the last one beyond the full load

# linear SCENE QUANTITY REFERENCE RELATIVE: a linear benchmark.
linear() {
  expect 0 'load factor 1' "$scenes/$1.prm" --output "$1"
  expect_between "$1" "$2" "$(awk -v r="$3" -v e="$4" 'BEGIN { print r - e * (r < 0 ? -r : r) }')" \
    "$(awk -v r="$3" -v e="$4" 'BEGIN { print r + e * (r < 0 ? -r : r) }')"
}
linear scordelis-lo edge_uy -0.3006 0.001
linear pinched-cylinder load_uy -1.8248e-5 0.005
linear pinched-hemisphere inward_uy -0.0935 0.005
linear pinched-hemisphere-closed inward_uy -0.0924 0.005
linear plate-simply-supported centre_uz 0.004062352661 1e-5
linear plate-clamped centre_uz 0.001265319088 2e-5
linear plate-circular centre_uz 0.015625 5e-5
expect 0 'load factor 1' "$scenes/uniaxial-strip.prm" --output strip
expect_between strip corner_ux 0.999999 1.000001
expect_between strip corner_uy -0.2928933 -0.2928931

finish
