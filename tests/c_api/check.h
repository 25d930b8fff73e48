/* Checks of a program in C: each failure is a line, and the program goes on. */
#ifndef AUREOLE_TESTS_C_API_CHECK_H
#define AUREOLE_TESTS_C_API_CHECK_H

#include <aureole.h>
#include <stdio.h>

extern int failures;

#define CHECK(condition)                                                                                          \
    do {                                                                                                          \
        if (!(condition)) {                                                                                       \
            printf("%s:%d: FAILED: %s (last error: %s)\n", __FILE__, __LINE__, #condition, aureole_last_error()); \
            ++failures;                                                                                           \
        }                                                                                                         \
    } while (0)
#define CHECK_OK(call) CHECK((call) == AUREOLE_OK)

#endif
