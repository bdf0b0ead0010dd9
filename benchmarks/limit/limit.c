/* What a search costs in C: every pair of search and function, and the parts of a run alone. */

#include "draws.h"
#include "functions.h"
#include "searches.h"

#define PAIR(search, function)                                                                   \
    double search##_##function(const double *bounds, int64_t n, int64_t population,              \
                               int64_t iterations, const double *parameters, uint64_t *state,    \
                               double *history)                                                  \
    {                                                                                            \
        return search(function, bounds, n, population, iterations, parameters, state, history);  \
    }
#define PAIRS(search)                                                                            \
    PAIR(search, sphere) PAIR(search, rastrigin) PAIR(search, ackley) PAIR(search, penalized_1)

PAIRS(woa)
PAIRS(pso)
PAIRS(de)

/* The same with the cost behind a pointer that the compiler cannot see through. */

static cost_function *volatile hidden = sphere;

#define BY_POINTER(search)                                                                       \
    double search##_by_pointer(const double *bounds, int64_t n, int64_t population,              \
                               int64_t iterations, const double *parameters, uint64_t *state,    \
                               double *history)                                                  \
    {                                                                                            \
        return search(hidden, bounds, n, population, iterations, parameters, state, history);    \
    }

BY_POINTER(woa)
BY_POINTER(pso)
BY_POINTER(de)

/* The floor: `count` values of one kind, each added up so that none can be left out. */

double draws_alone(const double *x, int64_t count, uint64_t *state)
{
    (void)x;
    double total = 0.0;
    for (int64_t i = 0; i < count; i++)
        total += uniform(state);
    return total;
}

#define ALONE(name, value)                                                                       \
    double name##_alone(const double *x, int64_t count, uint64_t *state)                         \
    {                                                                                            \
        (void)state;                                                                             \
        double total = 0.0;                                                                      \
        for (int64_t i = 0; i < count; i++)                                                      \
            total += value;                                                                      \
        return total;                                                                            \
    }

ALONE(cosines, cos(x[i]))
ALONE(sines, sin(x[i]))
ALONE(exponentials, exp(x[i]))
