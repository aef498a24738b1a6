/* Tells an exported controller what standard input says, and writes what it answers: numbers as bits. */
#define LOOP_DECLARATIONS_ONLY
#include "loop.c"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char line[4096];
static char *next_word;

static BITS integer(void)
{
    return (BITS)strtoull(next_word, &next_word, 16);
}

static REAL number(void)
{
    const BITS bits = integer();
    REAL value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static unsigned long long bits_of(REAL value)
{
    BITS bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

int main(void)
{
    static loop_state state;
    static loop_settings given;
    while (fgets(line, sizeof line, stdin)) {
        next_word = line + 1;
        if (line[0] == 'd') {
            given = loop_design;
        } else if (line[0] == 's') {
        /* the settings */
        } else if (line[0] == 'f') {
            const char *const fault = loop_fault(&given);
            printf("%s\n", fault ? fault : "good");
        } else if (line[0] == 'o') {
            printf("%d\n", loop_switch_on(&state, &given, number()));
        } else if (line[0] == 'r') {
            const REAL setpoint = number();
            const REAL controlled_variable = number();
            printf("%d\n", loop_at_rest(&state, &given, setpoint, controlled_variable, number()));
        } else {
            loop_input input;
            input.sample_period = number();
            input.setpoint = number();
            input.measured = integer() != 0;
            input.controlled_variable = number();
            input.feed_forward = number();
            input.applied_known = integer() != 0;
            input.applied = number();
            input.mode = (loop_mode)integer();
            input.manual_output = number();
            const loop_output output = loop_update(&state, &given, &input);
            printf("%DIGITS %DIGITS %d %DIGITS %d\n", bits_of(output.manipulated_variable), bits_of(output.wanted),
                   (int)output.limited, bits_of(output.load_estimate), (int)output.status);
        }
    }
    return 0;
}
