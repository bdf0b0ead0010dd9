/* Random numbers as in repro/determinism/draws.py: xoshiro256**, doi:10.1145/3460772. */

#include <stdint.h>

static inline uint64_t rotated(uint64_t word, int bits)
{
    return (word << bits) | (word >> (64 - bits));
}

#ifdef COUNT_DRAWS
int64_t draws_made = 0;
#define COUNT_ONE draws_made++
#else
#define COUNT_ONE (void)0
#endif

static inline double uniform(uint64_t state[4])
{
    COUNT_ONE;
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
