// The functions of FMI 2. Those of model exchange and of derivatives are refused: a world is co-simulated.
#include <cstdlib>

#include "fmi/calls.h"
#include "fmi/standard/fmi2Functions.h"

namespace {

namespace fmi = cli::fmi;
using cli::Bytes;
using cli::RunningUnit;
using cli::Variable;

template <typename Work>
fmi2Status guarded(fmi2Component component, Work work) {
  return fmi::guarded<fmi2Status>(component, work);
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
  if (path.size() > 2 && path[0] == '/' && path[2] == ':')
    path.erase(0, 1);  // "/C:/": Windows' paths begin with a letter
  while (path.size() > 1 && (path.back() == '/' || path.back() == '\\')) path.pop_back();
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
  if (kind != fmi2CoSimulation) {
    say("the unit is for co-simulation, not model exchange");
    return nullptr;
  }
  return fmi::instantiate([=] { return path_of(resources == nullptr ? "" : resources); }, guid, say);
}

void fmi2FreeInstance(fmi2Component component) { delete static_cast<RunningUnit*>(component); }

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean, size_t, const fmi2String[]) {
  return guarded(component, [](RunningUnit&) {});  // errors are always logged, and nothing else is
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean, fmi2Real) {
  return guarded(component, [&](RunningUnit& unit) { unit.experiment_start = start; });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  return guarded(component, [](RunningUnit& unit) { unit.initialize(unit.experiment_start); });
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
  return guarded(component, [&](RunningUnit& unit) { fmi::keep_state(state, unit.save()); });
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  return guarded(component, [&](RunningUnit& unit) { unit.load(fmi::bytes_of(state)); });
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return guarded(component, [&](RunningUnit&) { fmi::free_state(state); });
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t* size) {
  return guarded(component, [&](RunningUnit&) { *size = fmi::bytes_of(state).size(); });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  return guarded(component, [&](RunningUnit&) { fmi::write_state(state, bytes, size); });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state) {
  return guarded(component, [&](RunningUnit&) { fmi::keep_state(state, Bytes(bytes, bytes + size)); });
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
