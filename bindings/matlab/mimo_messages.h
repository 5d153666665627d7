/* What the library has to say about scenes and worlds, until somebody asks. */
#ifndef MIMO_MATLAB_MESSAGES_H
#define MIMO_MATLAB_MESSAGES_H

#include "mimo_base.h"

/* For a config: the function that keeps messages, and whose they are, by its number. */
void mimo_keep_message(void* user, const mimo_log_record* record);
void* mimo_teller(double number);

/* All of them, the oldest first, a struct each; they are forgotten. */
mxArray* mimo_take_messages(void);

#endif
