#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# check_arrows.sh must pass a good tree, and fail each tree with one violation.
set -u
check=$(dirname "$0")/check_arrows.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
n_failures=0

good_tree() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/include/semilunar/{core,spline,shell} "$tree"/source/{spline,shell}
  echo '#if DEAL_II_VERSION_GTE(9, 5, 0)' >"$tree/include/semilunar/core/compat.h"
  echo '#include <semilunar/core/log.h>' >"$tree/source/spline/surface.cc"
  echo '#include <semilunar/spline/surface.h>' >"$tree/source/shell/assembly.cc"
  echo '#include <semilunar/scene/scene.h>' >"$tree/source/main.cc"
}

# expect VERDICT FILE LINE: a good tree with this line added to this file
expect() {
  local verdict=passes
  good_tree
  mkdir -p "$(dirname "$tree/$2")"
  echo "$3" >>"$tree/$2"
  bash "$check" "$tree" >"$tree/report" || verdict=fails
  if [[ $verdict != "$1" ]]; then
    echo "the check $verdict with '$3' in $2:"
    cat "$tree/report"
    n_failures=$((n_failures + 1))
  elif [[ $verdict == fails ]] && ! grep -q "^$2" "$tree/report"; then
    echo "the report does not name $2"
    n_failures=$((n_failures + 1))
  fi
}

expect passes source/shell/assembly.cc '#include <semilunar/core/log.h>'
expect passes source/scene/statics.cc '#include <semilunar/output/summary.h>'
expect fails source/shell/assembly.cc '#include <semilunar/output/summary.h>'
expect fails source/shell/assembly.cc '# include <semilunar/valve/design.h>'
expect fails include/semilunar/core/log.h '#include <semilunar/spline/surface.h>'
expect fails source/valve/design.cc '#include <semilunar/shell/section.h>'
expect fails source/main.cc '#include <semilunar/shell/section.h>'
expect fails source/spline/surface.cc '#include "../shell/section.h"'
expect fails source/shell/assembly.cc '#include <deal.II/dofs/dof_handler.h>'
expect fails source/shell/assembly.cc '#include <deal.II/grid/tria.h>'
expect fails source/spline/surface.cc '#if DEAL_II_VERSION_GTE(9, 5, 0)'
expect fails source/attic/old.cc '#include <vector>'

rm -rf "${tree:?}"/*
if bash "$check" "$tree" >/dev/null 2>&1; then
  echo "the check passes an empty tree"
  n_failures=$((n_failures + 1))
fi

[[ $n_failures -eq 0 ]] && echo "all verdicts are right"
