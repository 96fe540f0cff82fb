"""The simulator: one scenario or thousands of candidates of it at a time, in compiled kernels.

All candidates share the paths and the structure of the speed programs; they differ in start
offset, speeds, trigger values, target speeds and rates. Tests hold it against a slow, obvious one.
"""

from scegen.motion.batch.arrays import BatchTraces, Candidates, Program, TriggerKind, empty_traces
from scegen.motion.batch.compilation import (
    Phase,
    build_program,
    compile_program,
    repeat,
    stack_scenario,
    stack_traces,
)
from scegen.motion.batch.simulation import simulate, simulate_batch

__all__ = [
    "BatchTraces",
    "Candidates",
    "Phase",
    "Program",
    "TriggerKind",
    "build_program",
    "compile_program",
    "empty_traces",
    "repeat",
    "simulate",
    "simulate_batch",
    "stack_scenario",
    "stack_traces",
]
