"""optuna: every coordinate is a suggestion of a trial."""

import optuna

optuna.logging.set_verbosity(optuna.logging.ERROR)


def parzen(cost, bounds, budget, rng):
    """Run the tree-structured Parzen estimator of optuna."""
    sampler = optuna.samplers.TPESampler(seed=int(rng.integers(2**31)))
    study = optuna.create_study(sampler=sampler)

    def objective(trial):
        return cost([trial.suggest_float(f"x{k}", *pair) for k, pair in enumerate(bounds)])

    study.optimize(objective, n_trials=budget)
    return [study.best_params[f"x{k}"] for k in range(len(bounds))]
