#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/test.sh [options of ctest]
#
# Installs what is missing, builds the program and all tests and runs them. Ends with the summary of
# ctest; contrib/test.sh -R ^shell/ runs the tests of one room.
set -eu
source "$(dirname "$0")/prepare.sh"

# deal.II's test driver takes this file for the trace of an interrupted test, and then runs the test
# from scratch. It puts it aside after each test; building the tests before needs the same.
move_guards() {
  find "$build/tests" -name "interrupt_guard.cc$1" 2>/dev/null | while read -r guard; do
    mv "$guard" "${guard%"$1"}$2"
  done
}

move_guards _bck ""
prepare all test_programs
move_guards "" _bck

cd "$build"
n_tests=$(ctest -N "$@" | sed -n 's/^Total Tests: //p')
[[ ${n_tests:-0} -gt 0 ]] || die "there are no tests"
say "running $n_tests tests"
ctest --output-on-failure -j "$(nproc)" "$@"
