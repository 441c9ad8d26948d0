#!/usr/bin/env bash
# Gradescope runs this once, when it builds the image (Ubuntu 24.04: Python 3.12). A copy of rosspin's repository, or a
# wheel of it, is in the same zip as this file.
set -e
apt-get update
apt-get install -y python3-venv
python3 -m venv /autograder/venv
/autograder/venv/bin/pip install /autograder/source/rosspin*
