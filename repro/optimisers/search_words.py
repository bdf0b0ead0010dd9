"""What the parameters of other people's searches are called, in small letters."""

COSTS = (
    *("cost", "fun", "func", "function", "f", "objective", "objective_function", "obj_func"),
    *("fitness", "obj", "fn", "objf", "obj_fun", "fobj", "fitness_func", "loss", "cost_func"),
    *("fitness_function", "cost_function"),
)
BOUNDS = ("bounds", "box", "limits", "ranges", "search_space", "domain")
BUDGETS = (
    *("budget", "evaluations", "maxfun", "maxfev", "max_evals", "max_evaluations", "n_calls"),
    *("max_fun", "nfev", "n_evals", "max_nfe", "maxfevals", "max_fevals", "max_fes", "maxfes"),
    *("max_nfev", "fes", "n_evaluations", "num_evaluations", "maxeval", "maxevals", "n_trials"),
)
GENERATORS = ("rng", "generator", "random_generator")
SEEDS = ("seed", "random_state", "random_seed")
STARTS = ("x0", "x_0", "initial_guess", "start")
OTHERS = {
    **dict.fromkeys(("lower", "lb", "xmin", "lower_bounds", "lower_bound", "xl", "low"), "lower"),
    **dict.fromkeys(("upper", "ub", "xmax", "upper_bounds", "upper_bound", "xu", "high"), "upper"),
    **dict.fromkeys(("dim", "dimension", "n", "n_dim", "ndim", "dimensions", "n_vars"), "size"),
    **dict.fromkeys(("sigma0",), "step"),
    **dict.fromkeys(
        ("population", "pop", "popsize", "pop_size", "population_size", "agents", "n_agents",
         "searchagents_no", "n_particles", "size_pop", "n_pop"), "population",
    ),
    **dict.fromkeys(
        ("iterations", "iters", "max_iter", "maxiter", "n_iter", "epochs", "epoch", "generations",
         "n_iterations", "max_iterations", "n_generations"), "iterations",
    ),
}  # fmt: skip
METHODS = ("minimise", "minimize", "optimise", "optimize", "solve", "search", "run")
"""What an object that is not called itself calls its search."""
