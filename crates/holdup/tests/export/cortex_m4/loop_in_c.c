/* The C export on the emulated Cortex-M4. */
#define LOOP_DECLARATIONS_ONLY
#include "loop.c"

#include "firmware.h"

static REAL number(uint64_t word)
{
    const union { BITS bits; REAL value; } of = {(BITS)word};
    return of.value;
}

static uint64_t bits(REAL value)
{
    const union { REAL value; BITS bits; } of = {value};
    return of.bits;
}

void run(bool (*next)(struct told *), void (*say)(const struct answer *))
{
    static loop_state state;
    struct told told;
    while (next(&told)) {
        const uint64_t *const words = told.words;
        struct answer answer = {0, 0, 0, 0, 0, 0, 0};
        if (told.kind == 'd') {
            continue;
        }
        if (told.kind == 'o') {
            answer.status = loop_switch_on(&state, &loop_design, number(words[0]));
        } else if (told.kind == 'r') {
            answer.status =
                loop_at_rest(&state, &loop_design, number(words[0]), number(words[1]), number(words[2]));
        } else {
            const loop_input input = {
                number(words[0]), number(words[1]), words[2] != 0, number(words[3]), number(words[4]),
                words[5] != 0, number(words[6]), (loop_mode)words[7], number(words[8])};
            const loop_output output = loop_update(&state, &loop_design, &input);
            answer.is_update = 1;
            answer.limited = output.limited;
            answer.status = output.status;
            answer.manipulated_variable = bits(output.manipulated_variable);
            answer.wanted = bits(output.wanted);
            answer.load_estimate = bits(output.load_estimate);
        }
        say(&answer);
    }
}
