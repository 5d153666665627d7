/*
 * Messages of the library. They come in the middle of a call, where the gateway must not call MATLAB, whose errors
 * would jump over the library. So they wait here.
 */
#include "mimo_messages.h"

#include <stdint.h>
#include <stdio.h>

#include "mimo_words.h"

enum { kKept = 256, kLength = 1024 };

typedef struct message {
  double number, time;
  size_t world;
  int32_t level, code;
  uint32_t in_world;
  char text[kLength];
} message;

/* A ring: if it is full, the oldest message goes. */
static message kept[kKept];
static size_t oldest, count;

void* mimo_teller(double number) { return (void*)(uintptr_t)number; }

void mimo_keep_message(void* user, const mimo_log_record* record) {
  message* to = &kept[(oldest + count) % kKept];
  if (count < kKept)
    ++count;
  else
    oldest = (oldest + 1) % kKept;
  to->number = (double)(uintptr_t)user;
  to->level = record->level;
  to->code = record->code;
  to->in_world = record->in_world;
  to->world = record->world;
  to->time = record->time;
  snprintf(to->text, sizeof to->text, "%s", mimo_counted(record->text));
}

/* Empty if the message comes from no world. */
static mxArray* of_world(const message* from, double value) {
  return from->in_world ? mxCreateDoubleScalar(value) : mxCreateDoubleMatrix(0, 0, mxREAL);
}

mxArray* mimo_take_messages(void) {
  static const char* members[] = {"number", "level", "code", "text", "world", "time"};
  mxArray* all = mxCreateStructMatrix(count, 1, 6, members);
  size_t i;
  for (i = 0; i < count; ++i) {
    const message* from = &kept[(oldest + i) % kKept];
    mxSetFieldByNumber(all, i, 0, mxCreateDoubleScalar(from->number));
    mxSetFieldByNumber(all, i, 1, mxCreateString(mimo_word_for(from->level, &mimo_log_level_words)));
    mxSetFieldByNumber(all, i, 2, mxCreateDoubleScalar(from->code));
    mxSetFieldByNumber(all, i, 3, mxCreateString(from->text));
    mxSetFieldByNumber(all, i, 4, of_world(from, (double)from->world + 1));
    mxSetFieldByNumber(all, i, 5, of_world(from, from->time));
  }
  count = 0;
  return all;
}
