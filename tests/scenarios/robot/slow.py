"""A module that takes its time to be imported."""

import scenario

scenario.mark("imported")
scenario.block(2)
value = 7
