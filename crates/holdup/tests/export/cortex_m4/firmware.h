/* What a controller on the emulated Cortex-M4 is told, and what it answers: numbers as bits. */
#include <stdbool.h>
#include <stdint.h>

struct told {
    uint32_t kind;     /* the letter that the line begins with */
    uint32_t padding;
    uint64_t words[9];
};

struct answer {
    uint32_t is_update; /* otherwise `status` says whether a controller was made */
    uint32_t limited;
    uint32_t status;
    uint32_t padding;
    uint64_t manipulated_variable;
    uint64_t wanted;
    uint64_t load_estimate;
};

/* The exported controllers, told the whole trace. */
void run(bool (*next)(struct told *), void (*say)(const struct answer *));
