/* Messages of the library, until MATLAB asks for them. */
#ifndef MIMO_MATLAB_MESSAGES_H
#define MIMO_MATLAB_MESSAGES_H

#include "mimo_base.h"

/* For a config: the function that keeps messages, and the number of their scene or worlds. */
void mimo_keep_message(void* user, const mimo_log_record* record);
void* mimo_teller(double number);

/* Returns and forgets all messages, the oldest first, as structs. */
mxArray* mimo_take_messages(void);

#endif
