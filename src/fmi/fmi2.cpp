// The functions of FMI 2. Those of model exchange and of derivatives are refused: a world is co-simulated.
#include <cstdlib>
#include <cstring>

#include "fmi/standard/fmi2Functions.h"
#include "fmi/unit.h"

namespace {

using cli::RunningUnit;
using cli::Variable;

struct Component {
  std::unique_ptr<RunningUnit> unit;
  double start = 0;  // s, as set up
};

RunningUnit& unit_of(fmi2Component component) { return *static_cast<Component*>(component)->unit; }

// What happens in here cannot leave as an exception: it is logged, and becomes a status.
template <typename Work>
fmi2Status guarded(fmi2Component component, Work work) {
  if (component == nullptr) return fmi2Error;
  try {
    work(unit_of(component));
    return fmi2OK;
  } catch (const std::exception& error) {
    unit_of(component).log(error.what());
  } catch (...) {
    unit_of(component).log("an unknown error");
  }
  return fmi2Error;
}

template <typename Work>
fmi2Status each(fmi2Component component, const fmi2ValueReference* references, std::size_t count, const char* type,
                Work work) {
  return guarded(component, [&](RunningUnit& unit) {
    for (std::size_t i = 0; i < count; ++i) unit.variable(references[i], type, 2);  // all, before one is changed
    for (std::size_t i = 0; i < count; ++i) work(unit, unit.variable(references[i], type, 2), i);
  });
}

// "file:///tmp/a%20b/resources" as a path.
std::string path_of(const std::string& uri) {
  constexpr char kScheme[] = "file:";
  std::string coded = uri;
  if (coded.compare(0, sizeof kScheme - 1, kScheme) == 0) {
    coded.erase(0, sizeof kScheme - 1);
    if (coded.compare(0, 2, "//") == 0) coded.erase(0, coded.find('/', 2));
  }
  std::string path;
  for (std::size_t i = 0; i < coded.size(); ++i) {
    const bool escape = coded[i] == '%' && i + 2 < coded.size();
    path += escape ? static_cast<char>(std::strtol(coded.substr(i + 1, 2).c_str(), nullptr, 16)) : coded[i];
    if (escape) i += 2;
  }
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

}  // namespace

extern "C" {

const char* fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char* fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type kind, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean) {
  const auto say = [functions, instance = std::string(name == nullptr ? "" : name)](const std::string& message) {
    if (functions == nullptr || functions->logger == nullptr) return;
    functions->logger(functions->componentEnvironment, instance.c_str(), fmi2Error, "logStatusError", "%s",
                      message.c_str());
  };
  try {
    if (kind != fmi2CoSimulation) throw std::runtime_error("the unit is for co-simulation, not model exchange");
    auto component = std::make_unique<Component>();
    component->unit =
        std::make_unique<RunningUnit>(path_of(resources == nullptr ? "" : resources), guid == nullptr ? "" : guid);
    component->unit->log = say;
    return component.release();
  } catch (const std::exception& error) {
    say(error.what());
  } catch (...) {
    say("an unknown error");
  }
  return nullptr;
}

void fmi2FreeInstance(fmi2Component component) { delete static_cast<Component*>(component); }

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean, size_t, const fmi2String[]) {
  return guarded(component, [](RunningUnit&) {});  // errors are always logged, and nothing else is
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean, fmi2Real) {
  return guarded(component, [&](RunningUnit&) { static_cast<Component*>(component)->start = start; });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  return guarded(component, [&](RunningUnit& unit) { unit.initialize(static_cast<Component*>(component)->start); });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
  return guarded(component, [](RunningUnit& unit) { unit.start(); });
}

fmi2Status fmi2Terminate(fmi2Component component) {
  return guarded(component, [](RunningUnit& unit) { unit.terminate(); });
}

fmi2Status fmi2Reset(fmi2Component component) {
  return guarded(component, [](RunningUnit& unit) { unit.reset(); });
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real seconds, fmi2Boolean) {
  return guarded(component, [&](RunningUnit& unit) { unit.step(time, seconds); });
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[]) {
  return each(component, references, count, "Real",
              [&](RunningUnit& unit, const Variable& it, std::size_t i) { unit.get(it, &values[i]); });
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Integer values[]) {
  return each(component, references, count, "Integer",
              [&](RunningUnit& unit, const Variable& it, std::size_t i) { unit.get(it, &values[i]); });
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Boolean values[]) {
  return each(component, references, count, "Boolean", [&](RunningUnit& unit, const Variable& it, std::size_t i) {
    std::uint8_t flag = 0;
    unit.get(it, &flag);
    values[i] = flag != 0 ? fmi2True : fmi2False;
  });
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]) {
  return each(component, references, count, "Real",
              [&](RunningUnit& unit, const Variable& it, std::size_t i) { unit.set_action(it, values[i]); });
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[]) {
  return each(component, references, count, "Integer", [&](RunningUnit& unit, const Variable& it, std::size_t i) {
    if (it.kind != Variable::kSeed) throw std::runtime_error(it.name + " is no input");
    if (values[i] < 0) throw std::runtime_error("seed is " + std::to_string(values[i]) + ", expected 0 or more");
    unit.set_seed(static_cast<std::uint64_t>(values[i]));
  });
}

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return guarded(component, [&](RunningUnit& unit) {
    cli::Bytes bytes = unit.save();
    if (*state == nullptr) *state = new cli::Bytes;
    static_cast<cli::Bytes*>(*state)->swap(bytes);
  });
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  return guarded(component, [&](RunningUnit& unit) {
    if (state == nullptr) throw std::runtime_error("FMUstate is NULL");
    unit.load(*static_cast<const cli::Bytes*>(state));
  });
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return guarded(component, [&](RunningUnit&) {
    if (state == nullptr) return;
    delete static_cast<cli::Bytes*>(*state);
    *state = nullptr;
  });
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t* size) {
  return guarded(component, [&](RunningUnit&) { *size = static_cast<const cli::Bytes*>(state)->size(); });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  return guarded(component, [&](RunningUnit&) {
    const auto& from = *static_cast<const cli::Bytes*>(state);
    if (size < from.size()) {
      throw std::runtime_error("size is " + std::to_string(size) + ", expected " + std::to_string(from.size()));
    }
    std::memcpy(bytes, from.data(), from.size());
  });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state) {
  return guarded(component, [&](RunningUnit&) {
    auto made = std::make_unique<cli::Bytes>(bytes, bytes + size);
    if (*state == nullptr) *state = new cli::Bytes;
    static_cast<cli::Bytes*>(*state)->swap(*made);
  });
}

// A step is done when its call returns: there is nothing to ask for, and nothing to cancel.
#define MIMO_REFUSE(name, ...)                                                                            \
  fmi2Status name(fmi2Component component, __VA_ARGS__) {                                                 \
    return guarded(component, [](RunningUnit&) { throw std::runtime_error(#name " is not supported"); }); \
  }
using References = const fmi2ValueReference*;

MIMO_REFUSE(fmi2GetString, References, size_t, fmi2String*)
MIMO_REFUSE(fmi2SetString, References, size_t, const fmi2String*)
MIMO_REFUSE(fmi2SetBoolean, References, size_t, const fmi2Boolean*)
MIMO_REFUSE(fmi2GetDirectionalDerivative, References, size_t, References, size_t, const fmi2Real*, fmi2Real*)
MIMO_REFUSE(fmi2SetRealInputDerivatives, References, size_t, const fmi2Integer*, const fmi2Real*)
MIMO_REFUSE(fmi2GetRealOutputDerivatives, References, size_t, const fmi2Integer*, fmi2Real*)
MIMO_REFUSE(fmi2GetStatus, fmi2StatusKind, fmi2Status*)
MIMO_REFUSE(fmi2GetRealStatus, fmi2StatusKind, fmi2Real*)
MIMO_REFUSE(fmi2GetIntegerStatus, fmi2StatusKind, fmi2Integer*)
MIMO_REFUSE(fmi2GetBooleanStatus, fmi2StatusKind, fmi2Boolean*)
MIMO_REFUSE(fmi2GetStringStatus, fmi2StatusKind, fmi2String*)

fmi2Status fmi2CancelStep(fmi2Component component) {
  return guarded(component, [](RunningUnit&) { throw std::runtime_error("fmi2CancelStep is not supported"); });
}

}  // extern "C"
