#ifndef AUREOLE_TESTS_C_API_ERRORS_H
#define AUREOLE_TESTS_C_API_ERRORS_H

/* What bad input gets, on the CPU device. */
void check_errors(void);

#endif
