# SPDX-License-Identifier: LGPL-2.1-or-later
#
# cmake -D SOURCE=... -D HEADER=... -D VERSION=... -D TYPE=... -P write_build_header.cmake
#
# Runs in every build, so that the revision is never stale, but touches the header (which only
# source/core/version.cc includes) only if its contents change.
cmake_minimum_required(VERSION 3.21)

execute_process(COMMAND git describe --always --dirty --abbrev=10
  WORKING_DIRECTORY ${SOURCE}
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"namespace semilunar::build
{
  constexpr const char *version = \"@VERSION@\";
  constexpr const char *revision = \"@revision@\";
  constexpr const char *type = \"@TYPE@\";
  constexpr const char *scene_file_folder = \"@SOURCE@/prm\";
} // namespace semilunar::build
")
