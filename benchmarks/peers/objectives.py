"""The benchmark functions as a user of these libraries writes them: NumPy over one point."""

from collections.abc import Callable
from typing import Any

Objective = Callable[[Any], Any]


def objectives(np: Any) -> dict[str, Objective]:  # noqa: ANN401 (NumPy, or JAX's likeness of it)
    """Return the functions by name, each from a point of shape (n,) to its value."""

    def sphere(x: Any) -> Any:  # noqa: ANN401
        return np.sum(x**2)

    def rastrigin(x: Any) -> Any:  # noqa: ANN401
        return np.sum(x**2 - 10.0 * np.cos(2.0 * np.pi * x)) + 10.0 * len(x)

    def ackley(x: Any) -> Any:  # noqa: ANN401
        squares, waves = np.mean(x**2), np.mean(np.cos(2.0 * np.pi * x))
        return -20.0 * np.exp(-0.2 * np.sqrt(squares)) - np.exp(waves) + 20.0 + np.e

    def penalized_1(x: Any) -> Any:  # noqa: ANN401
        y = 1.0 + (x + 1.0) / 4.0
        inner = (y[:-1] - 1.0) ** 2 * (1.0 + 10.0 * np.sin(np.pi * y[1:]) ** 2)
        ends = 10.0 * np.sin(np.pi * y[0]) ** 2 + (y[-1] - 1.0) ** 2
        outside = np.maximum(np.abs(x) - 10.0, 0.0)
        return np.pi / len(x) * (ends + np.sum(inner)) + 100.0 * np.sum(outside**4)

    return {f.__name__: f for f in (sphere, rastrigin, ackley, penalized_1)}
