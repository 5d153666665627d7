#include "render/shelf.h"

#include "render/renderer.h"

namespace mimo::render {

std::shared_ptr<Shelf> make_shelf() { return std::make_shared<Shelf>(); }

}  // namespace mimo::render
