#include <locale.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif

#include "base/plain_numbers.h"

namespace mimo {

struct PlainNumbers::Locale {
  locale_t plain, previous;
};

PlainNumbers::PlainNumbers() : before_(std::make_unique<Locale>()) {
  before_->plain = newlocale(LC_ALL_MASK, "C", nullptr);
  before_->previous = uselocale(before_->plain);
}

PlainNumbers::~PlainNumbers() {
  uselocale(before_->previous);
  if (before_->plain != nullptr) freelocale(before_->plain);
}

}  // namespace mimo
