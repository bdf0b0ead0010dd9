/* WOA, PSO and DE with the draws, their order and the roundings of repro/optimisers.

always_inline: each caller gets a loop of its own with its cost in it, which is more than the
compiled Python may do, since that reaches every cost through a pointer. */

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define SEARCH __attribute__((always_inline)) static inline double

static inline double held(double x, const double *bounds)
{
    double inside = x < bounds[0] ? bounds[0] : x;
    return inside > bounds[1] ? bounds[1] : inside;
}

static inline void clip(double *x, const double *bounds, int64_t n)
{
    for (int64_t j = 0; j < n; j++)
        x[j] = held(x[j], bounds + 2 * j);
}

static inline void copy_into(double *target, const double *source, int64_t n)
{
    memcpy(target, source, (size_t)n * sizeof *target);
}

/* Population drawn dimension by dimension, then `more` rows of room. */
static double *started(const double *bounds, int64_t n, int64_t population, int64_t more,
                       uint64_t *state)
{
    double *X = calloc((size_t)((population + more) * n), sizeof *X);
    if (X == NULL)
        abort();
    for (int64_t j = 0; j < n; j++)
        for (int64_t i = 0; i < population; i++)
            X[i * n + j] = bounds[2 * j] + (bounds[2 * j + 1] - bounds[2 * j]) * uniform(state);
    return X;
}

SEARCH woa(cost_function *cost, const double *bounds, int64_t n, int64_t population,
           int64_t iterations, const double *parameters, uint64_t *state, double *history)
{
    double b = parameters[0];
    double *X = started(bounds, n, population, 1, state), *best = X + population * n;
    double best_cost = INFINITY;
    for (int64_t t = 0; t < iterations; t++) {
        for (int64_t i = 0; i < population; i++) {
            double *x = X + i * n;
            clip(x, bounds, n);
            double value = cost(x, n);
            if (value < best_cost) {
                best_cost = value;
                copy_into(best, x, n);
            }
        }
        history[t] = best_cost;
        double a = 2.0 - 2.0 * (double)t / (double)iterations;
        double a2 = -1.0 - (double)t / (double)iterations;
        for (int64_t i = 0; i < population; i++) {
            double *x = X + i * n;
            double A = 2.0 * a * uniform(state) - a; /* Eq. (2.3) */
            double C = 2.0 * uniform(state);         /* Eq. (2.4) */
            double l = (a2 - 1.0) * uniform(state) + 1.0;
            if (uniform(state) < 0.5) {
                if (fabs(A) < 1.0)
                    for (int64_t j = 0; j < n; j++) /* Eqs. (2.1)-(2.2) */
                        x[j] = best[j] - A * fabs(C * best[j] - x[j]);
                else
                    for (int64_t j = 0; j < n; j++) { /* Eqs. (2.7)-(2.8) */
                        double leader = X[below(population, state) * n + j];
                        x[j] = leader - A * fabs(C * leader - x[j]);
                    }
            } else {
                double turn = exp(b * l) * cosine_of_turns(l);
                for (int64_t j = 0; j < n; j++) /* Eq. (2.5) */
                    x[j] = fabs(best[j] - x[j]) * turn + best[j];
            }
        }
    }
    free(X);
    return best_cost;
}

SEARCH pso(cost_function *cost, const double *bounds, int64_t n, int64_t population,
           int64_t iterations, const double *parameters, uint64_t *state, double *history)
{
    double v_max = parameters[0], w_first = parameters[1], w_last = parameters[2];
    double c1 = parameters[3], c2 = parameters[4];
    int64_t first_clipped = parameters[5] == 1.0 ? 0 : population - 1;
    double *X = started(bounds, n, population, 2 * population + 2, state);
    double *V = X + population * n, *P = V + population * n, *best = P + population * n;
    double *costs = malloc((size_t)population * sizeof *costs), best_cost = INFINITY;
    for (int64_t i = 0; i < population; i++)
        costs[i] = INFINITY;
    for (int64_t t = 1; t <= iterations; t++) {
        for (int64_t i = first_clipped; i < population; i++)
            clip(X + i * n, bounds, n);
        for (int64_t i = 0; i < population; i++) {
            double *x = X + i * n, value = cost(x, n);
            if (value < costs[i]) {
                costs[i] = value;
                copy_into(P + i * n, x, n);
            }
            if (value < best_cost) {
                best_cost = value;
                copy_into(best, x, n);
            }
        }
        history[t - 1] = best_cost;
        double w = w_first - (double)t * (w_first - w_last) / (double)iterations;
        for (int64_t i = 0; i < population; i++) {
            double *x = X + i * n, *v = V + i * n, *p = P + i * n;
            for (int64_t j = 0; j < n; j++) {
                double memory = c1 * uniform(state) * (p[j] - x[j]);
                double swarm = c2 * uniform(state) * (best[j] - x[j]);
                double wanted = w * v[j] + memory + swarm;
                double least = wanted < -v_max ? -v_max : wanted;
                v[j] = least > v_max ? v_max : least;
                x[j] += v[j];
            }
        }
    }
    free(costs);
    free(X);
    return best_cost;
}

SEARCH de(cost_function *cost, const double *bounds, int64_t n, int64_t population,
          int64_t iterations, const double *parameters, uint64_t *state, double *history)
{
    double least = parameters[0], most = parameters[1], CR = parameters[2];
    double *X = started(bounds, n, population, 1, state), *y = X + population * n;
    double *costs = malloc((size_t)population * sizeof *costs), best_cost = INFINITY;
    for (int64_t i = 0; i < population; i++) {
        costs[i] = cost(X + i * n, n);
        best_cost = costs[i] < best_cost ? costs[i] : best_cost;
    }
    for (int64_t t = 0; t < iterations; t++) {
        for (int64_t i = 0; i < population; i++) {
            double *x = X + i * n;
            int64_t a = i, b = i, c = i;
            while (a == i)
                a = below(population, state);
            while (b == i || b == a)
                b = below(population, state);
            while (c == i || c == a || c == b)
                c = below(population, state);
            for (int64_t j = 0; j < n; j++) {
                double F = least + (most - least) * uniform(state);
                y[j] = X[a * n + j] + F * (X[b * n + j] - X[c * n + j]);
            }
            clip(y, bounds, n);
            int64_t certain = below(n, state);
            for (int64_t j = 0; j < n; j++)
                if (j != certain && uniform(state) > CR)
                    y[j] = x[j];
            double value = cost(y, n);
            if (value < costs[i]) {
                costs[i] = value;
                copy_into(x, y, n);
            }
            if (value < best_cost)
                best_cost = value;
        }
        history[t] = best_cost;
    }
    free(costs);
    free(X);
    return best_cost;
}
