/* Benchmark functions with the operations and their order of repro/functions. */

#include <math.h>
#include <stdint.h>

typedef double cost_function(const double *x, int64_t n);

static inline double sphere(const double *x, int64_t n)
{
    double total = 0.0;
    for (int64_t j = 0; j < n; j++)
        total += x[j] * x[j];
    return total;
}

static inline double rastrigin(const double *x, int64_t n)
{
    double total = 0.0;
    for (int64_t j = 0; j < n; j++)
        total += x[j] * x[j] - 10.0 * cos(2.0 * M_PI * x[j]);
    return total + 10.0 * (double)n;
}

static inline double ackley(const double *x, int64_t n)
{
    double squares = 0.0, waves = 0.0;
    for (int64_t j = 0; j < n; j++) {
        squares += x[j] * x[j];
        waves += cos(2.0 * M_PI * x[j]);
    }
    return -20.0 * exp(-0.2 * sqrt(squares / (double)n)) - exp(waves / (double)n) + 20.0 + M_E;
}

static inline double squared_sine(double angle)
{
    double sine = sin(angle);
    return sine * sine;
}

static inline double fourth_power(double base)
{
    double square = base * base;
    return square * square;
}

static inline double outside(double x)
{
    if (x > 10.0)
        return 100.0 * fourth_power(x - 10.0);
    if (x < -10.0)
        return 100.0 * fourth_power(-x - 10.0);
    return 0.0;
}

static inline double penalized_1(const double *x, int64_t n)
{
    double y = 1.0 + (x[0] + 1.0) / 4.0;
    double total = 10.0 * squared_sine(M_PI * y);
    double penalty = outside(x[0]);
    for (int64_t j = 1; j < n; j++) {
        double y_next = 1.0 + (x[j] + 1.0) / 4.0;
        total += (y - 1.0) * (y - 1.0) * (1.0 + 10.0 * squared_sine(M_PI * y_next));
        penalty += outside(x[j]);
        y = y_next;
    }
    total += (y - 1.0) * (y - 1.0);
    return M_PI / (double)n * total + penalty;
}
