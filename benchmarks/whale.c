/* WOA on the sphere in plain C: the draws, their order and the roundings of repro/optimisers/whale.py.

woa_by_pointer reaches the cost through a pointer that the compiler cannot see through, as the
compiled Python must; woa_inlined lets it put the cost into the loop. */

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

typedef double cost_function(const double *x, int64_t n);

static double sphere(const double *x, int64_t n)
{
    double total = 0.0;
    for (int64_t j = 0; j < n; j++)
        total += x[j] * x[j];
    return total;
}

static inline uint64_t rotated(uint64_t word, int bits)
{
    return (word << bits) | (word >> (64 - bits));
}

/* xoshiro256**, doi:10.1145/3460772 */
static inline double uniform(uint64_t state[4])
{
    uint64_t word = rotated(state[1] * 5, 7) * 9;
    uint64_t shifted = state[1] << 17;
    state[2] ^= state[0];
    state[3] ^= state[1];
    state[1] ^= state[2];
    state[0] ^= state[3];
    state[2] ^= shifted;
    state[3] = rotated(state[3], 45);
    return (double)(word >> 11) * 0x1p-53;
}

static inline int64_t below(int64_t n, uint64_t state[4])
{
    return (int64_t)((double)n * uniform(state));
}

/* always_inline: each caller below gets a loop of its own, with its cost in it or not */
__attribute__((always_inline)) static inline double
woa(cost_function *cost, const double *bounds, int64_t n, int64_t population, int64_t iterations,
    double b, uint64_t *state, double *best, double *history)
{
    double *X = malloc((size_t)(population * n) * sizeof *X);
    if (X == NULL)
        return NAN;
    for (int64_t j = 0; j < n; j++)
        for (int64_t i = 0; i < population; i++)
            X[i * n + j] = bounds[2 * j] + (bounds[2 * j + 1] - bounds[2 * j]) * uniform(state);
    double best_cost = INFINITY;
    for (int64_t t = 0; t < iterations; t++) {
        for (int64_t i = 0; i < population; i++) {
            double *x = X + i * n;
            for (int64_t j = 0; j < n; j++) {
                double inside = x[j] < bounds[2 * j] ? bounds[2 * j] : x[j];
                x[j] = inside > bounds[2 * j + 1] ? bounds[2 * j + 1] : inside;
            }
            double value = cost(x, n);
            if (value < best_cost) {
                best_cost = value;
                for (int64_t j = 0; j < n; j++)
                    best[j] = x[j];
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
                double turn = exp(b * l) * cos(2.0 * M_PI * l);
                for (int64_t j = 0; j < n; j++) /* Eq. (2.5) */
                    x[j] = fabs(best[j] - x[j]) * turn + best[j];
            }
        }
    }
    free(X);
    return best_cost;
}

static cost_function *volatile opaque = sphere;

double woa_by_pointer(const double *bounds, int64_t n, int64_t population, int64_t iterations,
                      double b, uint64_t *state, double *best, double *history)
{
    return woa(opaque, bounds, n, population, iterations, b, state, best, history);
}

double woa_inlined(const double *bounds, int64_t n, int64_t population, int64_t iterations,
                   double b, uint64_t *state, double *best, double *history)
{
    return woa(sphere, bounds, n, population, iterations, b, state, best, history);
}
