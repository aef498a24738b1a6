/* Start-up of the emulated Cortex-M4 (mps2-an386): the trace is part of the image, the answers go out by semihosting. */
#include "firmware.h"

#include <stddef.h>

#define NUMBER_DIGITS DIGITS

__asm__(".section .rodata\n.global trace\ntrace:\n.incbin \"trace\"\n.byte 0\n.text\n");
extern const char trace[];
extern uint32_t stack_top;

static const char *place = trace;

static uint32_t semihosting(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static void end(void)
{
    semihosting(0x18, (const void *)0x20026); /* SYS_EXIT, the application has ended */
    for (;;) {
    }
}

static bool next(struct told *told)
{
    if (*place == 0) {
        return false;
    }
    told->kind = (uint8_t)*place++;
    for (int word = 0; word < 9; word++) {
        told->words[word] = 0;
        while (*place == ' ') {
            place++;
        }
        for (; *place > ' '; place++) {
            const uint32_t digit = (uint32_t)(*place <= '9' ? *place - '0' : *place - 'a' + 10);
            told->words[word] = (told->words[word] << 4) | digit;
        }
    }
    while (*place == '\n') {
        place++;
    }
    return true;
}

static char *hexadecimal(char *text, uint64_t number, int digits)
{
    for (int digit = digits - 1; digit >= 0; digit--) {
        *text++ = "0123456789abcdef"[(number >> (4 * digit)) & 15];
    }
    *text++ = ' ';
    return text;
}

static void say(const struct answer *answer)
{
    char line[80];
    char *text = line;
    if (answer->is_update) {
        text = hexadecimal(text, answer->manipulated_variable, NUMBER_DIGITS);
        text = hexadecimal(text, answer->wanted, NUMBER_DIGITS);
        text = hexadecimal(text, answer->limited, 1);
        text = hexadecimal(text, answer->load_estimate, NUMBER_DIGITS);
    }
    text = hexadecimal(text, answer->status, 1);
    text[-1] = '\n';
    *text = 0;
    semihosting(0x04, line); /* SYS_WRITE0 */
}

void reset(void)
{
    *(volatile uint32_t *)0xe000ed88 |= 0xfu << 20; /* CPACR: the floating-point unit on */
    __asm__ volatile("dsb\nisb");
    run(next, say);
    end();
}

static void fault(void)
{
    semihosting(0x04, "fault\n");
    end();
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &stack_top, (const void *)reset, (const void *)fault, (const void *)fault,
    (const void *)fault, (const void *)fault, (const void *)fault};

/* What the compiler calls by itself. */

__attribute__((weak)) void *memcpy(void *to, const void *from, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        ((char *)to)[i] = ((const char *)from)[i];
    }
    return to;
}

__attribute__((weak)) void *memset(void *to, int value, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        ((char *)to)[i] = (char)value;
    }
    return to;
}
