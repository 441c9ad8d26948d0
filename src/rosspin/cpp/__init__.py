"""C++ nodes in simulated time: compiled to WebAssembly, with a stand-in for roscpp, they go by the clock of the run."""

from .building import CompileError, Part, alone, build, build_together, compiler
from .lean import lean
from .nodejs import program

__all__ = ["CompileError", "Part", "alone", "build", "build_together", "compiler", "lean", "program"]
