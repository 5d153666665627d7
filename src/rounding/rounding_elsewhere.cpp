#include "rounding/rounding.h"

namespace cli {

RoundingNotes::RoundingNotes() = default;

RoundingNotes::~RoundingNotes() = default;

std::string RoundingNotes::rows() const { return ""; }

}  // namespace cli
