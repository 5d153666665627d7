#include "body/faces.h"

#include "mimo/experimental.h"

using namespace mimo;

extern "C" {

const char* mimo_face_name(size_t index) noexcept {
  return index < body::kFaces.size() ? body::kFaces[index] : nullptr;
}

}  // extern "C"
