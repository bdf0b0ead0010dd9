"""The same searches in C: compiled when they are asked for, called through ctypes."""

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from benchmarks.ours import DIMENSION, ITERATIONS, KERNELS, POPULATION, PROBLEMS, Outcome, State

_SOURCE = Path(__file__).with_name("limit") / "limit.c"
OPTIONS = {
    # without fused multiply-add, which rounds once where two operations round twice
    "exact": ("-O3", "-march=native", "-ffp-contract=off"),
    "plain": ("-O3", "-march=native", "-DLIBRARY"),
    "fast": ("-Ofast", "-march=native", "-DLIBRARY"),
    "counting": ("-O1", "-ffp-contract=off", "-DCOUNT_DRAWS"),
}
_POINTER, _COUNT = ctypes.c_void_p, ctypes.c_int64


def compiler() -> str | None:
    """Return the path of the C compiler, or None."""
    return shutil.which("cc")


@cache
def library(kind: str) -> ctypes.CDLL:
    """Return the loops compiled with the options of that kind."""
    target = Path(mkdtemp()) / f"{kind}.so"
    command = (
        compiler() or "cc",
        *OPTIONS[kind],
        "-shared",
        "-fPIC",
        "-o",
        str(target),
        str(_SOURCE),
        "-lm",
    )
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(target))


def in_c(
    kind: str, search: str, function: str, iterations: int = ITERATIONS, *, pointer: bool = False
) -> Callable[[State], Outcome]:
    """Return one run in C: random state, which it moves on, to outcome."""
    call = library(kind)[f"{search}_{'by_pointer' if pointer else function}"]
    call.restype = ctypes.c_double
    call.argtypes = [_POINTER, _COUNT, _COUNT, _COUNT, _POINTER, _POINTER, _POINTER]
    bounds = PROBLEMS[function].problem(DIMENSION).bounds
    parameters, history = np.array(KERNELS[search][1]), np.empty(iterations)

    def run(state: State) -> Outcome:
        cost = call(
            bounds.ctypes.data,
            DIMENSION,
            POPULATION,
            iterations,
            parameters.ctypes.data,
            state.ctypes.data,
            history.ctypes.data,
        )
        return cost, history.tolist()

    return run


def alone(kind: str, what: str, count: int) -> Callable[[State], float]:
    """Return what makes `count` draws, cosines, sines or exponentials: state to their sum."""
    call = library(kind)[f"{what}_alone"]
    call.restype, call.argtypes = ctypes.c_double, [_POINTER, _COUNT, _POINTER]
    x = np.random.default_rng(1).uniform(-30.0, 30.0, size=count)

    def run(state: State) -> float:
        total: float = call(x.ctypes.data, count, state.ctypes.data)
        return total

    return run


def draws_of(search: str, function: str) -> int:
    """Return how many random numbers one run draws."""
    made = ctypes.c_int64.in_dll(library("counting"), "draws_made")
    made.value = 0
    in_c("counting", search, function)(np.arange(1, 5, dtype=np.uint64))
    return made.value
