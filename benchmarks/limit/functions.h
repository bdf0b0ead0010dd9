/* Benchmark functions with the operations and their order of repro/functions and repro/determinism/sines.py.

With -DLIBRARY the cosine and the sine are those of the C library, as a plain program has them. */

#include <math.h>
#include <stdint.h>

#ifdef LIBRARY

static inline double cosine_of_turns(double turns)
{
    return cos(2.0 * M_PI * turns);
}

static inline double squared_sine(double angle)
{
    double sine = sin(angle);
    return sine * sine;
}

#else

#define ONE_BY_FACTORIAL(n) (1.0 / (double)(n))

static inline double sine_to_45_degrees(double d)
{
    double z = d * d, zz = z * z;
    double low = (1.0 - z * ONE_BY_FACTORIAL(6)) +
                 (ONE_BY_FACTORIAL(120) - z * ONE_BY_FACTORIAL(5040)) * zz;
    double high = (ONE_BY_FACTORIAL(362880) - z * ONE_BY_FACTORIAL(39916800)) +
                  (ONE_BY_FACTORIAL(6227020800) - z * ONE_BY_FACTORIAL(1307674368000)) * zz;
    return d * (low + high * (zz * zz));
}

static inline double cosine_of_turns(double turns)
{
    double part = fabs(turns - rint(turns));
    double sine = sine_to_45_degrees(M_PI * (part > 0.25 ? 0.5 - part : part));
    return part > 0.25 ? 2.0 * sine * sine - 1.0 : 1.0 - 2.0 * sine * sine;
}

static inline double squared_sine(double angle)
{
    const double largest = 0x1p20 * M_PI;
    angle = angle < -largest ? -largest : angle > largest ? largest : angle;
    double turns = rint(angle * (1.0 / M_PI));
    double rest = angle - turns * 0x1.921fb544p+1; /* pi in three parts */
    rest = fabs((rest - turns * 0x1.0b4611a6p-33) - turns * 0x1.3198a2e037073p-68);
    double sine = sine_to_45_degrees(rest > M_PI / 4.0 ? M_PI / 2.0 - rest : rest);
    return rest > M_PI / 4.0 ? 1.0 - sine * sine : sine * sine;
}

#endif

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
        total += x[j] * x[j] - 10.0 * cosine_of_turns(x[j]);
    return total + 10.0 * (double)n;
}

static inline double ackley(const double *x, int64_t n)
{
    double squares = 0.0, waves = 0.0;
    for (int64_t j = 0; j < n; j++) {
        squares += x[j] * x[j];
        waves += cosine_of_turns(x[j]);
    }
    return -20.0 * exp(-0.2 * sqrt(squares / (double)n)) - exp(waves / (double)n) + 20.0 + M_E;
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
