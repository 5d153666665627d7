/* Words that stand for the constants of mimo.h. */
#include "mimo_words.h"

#include <stdio.h>
#include <string.h>

/* "body, geom, position or frame" */
static const char* list(const enumeration* from) {
  static char text[1024];
  const word* one;
  size_t used = 0;
  text[0] = '\0';
  for (one = from->words; one->text != NULL && used + 64 < sizeof text; ++one) {
    const char* between = one == from->words ? "" : one[1].text == NULL ? " or " : ", ";
    used += (size_t)snprintf(text + used, sizeof text - used, "%s%s", between, one->text);
  }
  return text;
}

static int64_t value_of_text(const char* text, const char* what, const enumeration* from) {
  const word* one;
  for (one = from->words; one->text != NULL; ++one)
    if (strcmp(one->text, text) == 0) return one->value;
  mimo_refuse("%s is \"%s\", expected %s", what, text, list(from));
  return 0;
}

int64_t mimo_value_of(const mxArray* given, const char* what, const enumeration* from) {
  const char** texts;
  int64_t value = 0;
  size_t count, i;
  if (given != NULL && (mxIsNumeric(given) || mxIsLogical(given)))
    return (int64_t)mimo_whole(given, what, from->combine ? 0 : -2147483648.0,
                               from->combine ? 4294967295.0 : 2147483647.0);
  texts = mimo_texts(given, &count, what);
  if (!from->combine && count != 1) mimo_refuse("%s: expected one of %s", what, list(from));
  for (i = 0; i < count; ++i) value |= value_of_text(texts[i], what, from);
  return value;
}

const char* mimo_word_for(int64_t value, const enumeration* from) {
  const word* one;
  for (one = from->words; one->text != NULL; ++one)
    if (one->value == value) return one->text;
  return "";
}

quantity mimo_quantity_of(const mxArray* name) {
  const char* text = mimo_text(name, "quantity");
  const size_t length = strlen(text);
  const int now = length > 4 && strcmp(text + length - 4, "_now") == 0;
  const size_t rest = now ? length - 4 : length;
  const quantity* one;
  quantity found = {"", 0, 0, 0};
  for (one = mimo_quantities; one->name != NULL; ++one) {
    if (strlen(one->name) != rest || strncmp(text, one->name, rest) != 0) continue;
    found = *one;
    if (now) found.number |= MIMO_NOW;
    return found;
  }
  mexErrMsgIdAndTxt("mimo:NOT_FOUND", "no quantity %s; see help mimo_quantities", text);
  return found;
}
