#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/pictures.sh RUN_FOLDER [options]
#
# Renders a PNG picture of a surface from the folder of a run, for example
#   contrib/pictures.sh results/closure --field mipe --view top --out closed-valve.png
# Installs VTK for Python and a virtual display if they are missing: only pictures need them.
# contrib/pictures.sh --help prints the options.
set -eu
source "$(dirname "$0")/prepare.sh"

packages=(python3-vtk9 xvfb xauth libgl1-mesa-dri)
install_missing
# Debian's own Python, whatever else comes first in PATH: it is the one that has the packages.
exec xvfb-run -a -s "-screen 0 1600x1200x24" /usr/bin/python3 "$root/contrib/pictures.py" "$@"
