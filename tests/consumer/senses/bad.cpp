// Shared libraries that are no senses, each by one definition.
#include <mimo/mimo.hpp>
#include <stdexcept>

#ifndef NO_ENTRY
extern "C" MIMO_PLUGIN mimo_status mimo_sense_entry(mimo_sense* sense) {
#ifdef THROWS
  throw std::runtime_error("no nose here");
#endif
#ifdef FAILS
  return mimo_fail(MIMO_E_NOT_FOUND, "no file of odours");
#endif
  sense->name = "nose";
  sense->interface_version = MIMO_SENSE_INTERFACE;
#ifdef OTHER_VERSION
  sense->interface_version = 7;
#endif
  sense->open = [](void*, const mimo_env*, const mimo_sense_moment*, mimo_sense_needs*) -> mimo_status {
    return MIMO_OK;
  };
  return MIMO_OK;
}
#endif
