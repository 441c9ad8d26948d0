"""C++ nodes in simulated time: compiled to WebAssembly, with a stand-in for roscpp, they go by the clock of the run."""

from .building import CompileError, build, build_together, compiler
from .lean import lean
from .program import Program

__all__ = ["CompileError", "Program", "build", "build_together", "compiler", "lean"]
