#!/usr/bin/env bash
# Gradescope runs this once, when it builds the image (Ubuntu 24.04: Python 3.12). A copy of rosspin's repository, or a
# wheel of it, is in the same zip as this file. Another folder than Gradescope's can be given, to try it.
set -e
apt-get update
apt-get install -y python3-venv bubblewrap
cd "${1:-/autograder}"
python3 -m venv venv
venv/bin/pip install source/rosspin*
