"""Steady-state genetic algorithm in plain Python, after doi:10.21608/erjeng.2023.237586.1256."""

from collections.abc import Callable, Sequence

Bounds = Sequence[tuple[float, float]]


def steady_state_genetic(
    cost: Callable[[list[float]], float],
    bounds: Bounds,
    population: int,
    iterations: int,
    uniform: Callable[[], float],
    normal: Callable[[], float],
    *,
    crossover: float = 0.8,
    mutation: float = 0.01,
    mixing: str = "toss",
) -> tuple[list[float], float, list[float], int]:
    """Return best position, its cost, best cost after each iteration, and evaluations."""
    del normal  # all twins are called alike
    x = [[0.0] * len(bounds) for _ in range(population)]
    for j, (lower, upper) in enumerate(bounds):
        for i in range(population):
            x[i][j] = lower + (upper - lower) * uniform()
    costs = [cost(agent) for agent in x]
    tried = list(zip(costs, [list(agent) for agent in x], strict=True))
    history: list[float] = []
    for _ in range(iterations):
        for i in range(population):
            if uniform() < mutation:
                agent = [lower + (upper - lower) * uniform() for lower, upper in bounds]
                costs[i], x[i] = cost(agent), agent
                tried.append((costs[i], agent))
            elif uniform() < crossover:
                one, other = x[int(population * uniform())], x[int(population * uniform())]
                child = _child(one, other, uniform, mixing)
                tried.append((cost(child), child))
                if tried[-1][0] < costs[i]:
                    costs[i], x[i] = tried[-1]
        history.append(min(f for f, _ in tried))
    best_cost, best_x = min(tried, key=lambda pair: pair[0])
    return best_x, best_cost, history, len(tried)


def _child(
    one: list[float], other: list[float], uniform: Callable[[], float], mixing: str
) -> list[float]:
    if mixing == "one point":
        cut = 1 + int(max(len(one) - 1, 1) * uniform())
        return one[:cut] + other[cut:]
    return [_gene(a, b, uniform(), mixing) for a, b in zip(one, other, strict=True)]


def _gene(one: float, other: float, share: float, mixing: str) -> float:
    if mixing == "toss":
        return one if share < 0.5 else other
    return share * one + (1.0 - share) * other
