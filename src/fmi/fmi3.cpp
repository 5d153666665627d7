// The functions of FMI 3. Those of model exchange, scheduled execution and clocks are refused: a world is co-simulated.

#include "fmi/calls.h"
#include "fmi/standard/fmi3Functions.h"

namespace {

namespace fmi = cli::fmi;
using cli::Bytes;
using cli::RunningUnit;
using cli::Variable;

template <typename Work>
fmi3Status guarded(fmi3Instance instance, Work work) {
  return fmi::guarded<fmi3Status>(instance, work);
}

fmi3Status refused(fmi3Instance instance, const char* name) {
  return guarded(instance,
                 [&](RunningUnit&) { throw std::runtime_error(std::string(name) + " is not for co-simulation"); });
}

// Goes through variables whose elements lie one after the other.
template <typename Work>
fmi3Status each(fmi3Instance instance, const fmi3ValueReference* references, std::size_t count, const char* type,
                std::size_t values, Work work) {
  return guarded(instance, [&](RunningUnit& unit) {
    std::size_t needed = 0;
    for (std::size_t i = 0; i < count; ++i) needed += unit.variable(references[i], type, 3).count;
    if (needed != values) {
      throw std::runtime_error("nValues is " + std::to_string(values) + ", expected " + std::to_string(needed));
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Variable& it = unit.variable(references[i], type, 3);
      work(unit, it, at);
      at += it.count;
    }
  });
}

template <typename T>
fmi3Status get(fmi3Instance instance, const fmi3ValueReference* references, std::size_t count, const char* type,
               T* values, std::size_t room) {
  return each(instance, references, count, type, room,
              [&](RunningUnit& unit, const Variable& it, std::size_t at) { unit.get(it, values + at); });
}

template <typename T>
fmi3Status refuse_to_set(fmi3Instance instance, const fmi3ValueReference* references, std::size_t count,
                         const char* type, const T*, std::size_t room) {
  return each(instance, references, count, type, room, [](RunningUnit&, const Variable& it, std::size_t) {
    throw std::runtime_error(it.name + " is no input");
  });
}

}  // namespace

extern "C" {

const char* fmi3GetVersion(void) { return fmi3Version; }

fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean, fmi3Boolean,
                                         fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback) {
  const auto say = [=](const std::string& message) {
    if (log != nullptr) log(environment, fmi3Error, "logStatusError", message.c_str());
  };
  const auto folder = [=] {
    std::string path = resources == nullptr ? "" : resources;
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    return path;
  };
  return fmi::instantiate(folder, token, say);
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  if (log != nullptr)
    log(environment, fmi3Error, "logStatusError", "the unit is for co-simulation, not model exchange");
  return nullptr;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
  if (log != nullptr)
    log(environment, fmi3Error, "logStatusError", "the unit is for co-simulation, not scheduled execution");
  return nullptr;
}

void fmi3FreeInstance(fmi3Instance instance) { delete static_cast<RunningUnit*>(instance); }

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean, size_t, const fmi3String[]) {
  return guarded(instance, [](RunningUnit&) {});  // errors are always logged, and nothing else is
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64, fmi3Float64 start, fmi3Boolean,
                                       fmi3Float64) {
  return guarded(instance, [&](RunningUnit& unit) { unit.initialize(start); });
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return guarded(instance, [](RunningUnit& unit) { unit.start(); });
}

fmi3Status fmi3Terminate(fmi3Instance instance) {
  return guarded(instance, [](RunningUnit& unit) { unit.terminate(); });
}

fmi3Status fmi3Reset(fmi3Instance instance) {
  return guarded(instance, [](RunningUnit& unit) { unit.reset(); });
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 seconds, fmi3Boolean, fmi3Boolean* event,
                      fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* last) {
  return guarded(instance, [&](RunningUnit& unit) {
    for (fmi3Boolean* flag : {event, terminate, early}) {
      if (flag != nullptr) *flag = fmi3False;
    }
    if (last != nullptr) *last = time;
    unit.step(time, seconds);
    if (last != nullptr) *last = time + seconds;
  });
}

#define MIMO_GET(name, type)                                                                                          \
  fmi3Status fmi3Get##name(fmi3Instance instance, const fmi3ValueReference references[], size_t count, type values[], \
                           size_t room) {                                                                             \
    return get(instance, references, count, #name, values, room);                                                     \
  }
MIMO_GET(Float32, fmi3Float32)
MIMO_GET(Float64, fmi3Float64)
MIMO_GET(Int32, fmi3Int32)
MIMO_GET(UInt8, fmi3UInt8)
MIMO_GET(UInt64, fmi3UInt64)
#undef MIMO_GET

fmi3Status fmi3GetBoolean(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
                          fmi3Boolean values[], size_t room) {
  return each(instance, references, count, "Boolean", room, [&](RunningUnit& unit, const Variable& it, std::size_t at) {
    std::uint8_t flag = 0;
    unit.get(it, &flag);
    values[at] = flag != 0;
  });
}

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference references[], size_t count, size_t sizes[],
                         fmi3Binary values[], size_t room) {
  return guarded(instance, [&](RunningUnit& unit) {
    if (room != count) throw std::runtime_error("nValues is " + std::to_string(room) + ", expected one a picture");
    for (std::size_t i = 0; i < count; ++i) {
      const Variable& it = unit.variable(references[i], "Binary", 3);
      sizes[i] = it.count;
      values[i] = unit.picture(it);
    }
  });
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
                          const fmi3Float64 values[], size_t room) {
  return each(instance, references, count, "Float64", room,
              [&](RunningUnit& unit, const Variable& it, std::size_t at) { unit.set_action(it, values[at]); });
}

fmi3Status fmi3SetUInt64(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
                         const fmi3UInt64 values[], size_t room) {
  return each(instance, references, count, "UInt64", room,
              [&](RunningUnit& unit, const Variable&, std::size_t at) { unit.set_seed(values[at]); });
}

#define MIMO_NO_INPUT(name, type)                                                                      \
  fmi3Status fmi3Set##name(fmi3Instance instance, const fmi3ValueReference references[], size_t count, \
                           const type values[], size_t room) {                                         \
    return refuse_to_set(instance, references, count, #name, values, room);                            \
  }
MIMO_NO_INPUT(Float32, fmi3Float32)
MIMO_NO_INPUT(Int32, fmi3Int32)
MIMO_NO_INPUT(UInt8, fmi3UInt8)
MIMO_NO_INPUT(Boolean, fmi3Boolean)
#undef MIMO_NO_INPUT

// Types that no variable has: the reference is the mistake, and the message says so.
#define MIMO_NO_TYPE(name, type)                                                                                     \
  fmi3Status fmi3Get##name(fmi3Instance instance, const fmi3ValueReference references[], size_t count, type[],       \
                           size_t) {                                                                                 \
    return each(instance, references, count, #name, 0, [](RunningUnit&, const Variable&, std::size_t) {});           \
  }                                                                                                                  \
  fmi3Status fmi3Set##name(fmi3Instance instance, const fmi3ValueReference references[], size_t count, const type[], \
                           size_t) {                                                                                 \
    return each(instance, references, count, #name, 0, [](RunningUnit&, const Variable&, std::size_t) {});           \
  }
MIMO_NO_TYPE(Int8, fmi3Int8)
MIMO_NO_TYPE(Int16, fmi3Int16)
MIMO_NO_TYPE(UInt16, fmi3UInt16)
MIMO_NO_TYPE(UInt32, fmi3UInt32)
MIMO_NO_TYPE(Int64, fmi3Int64)
MIMO_NO_TYPE(String, fmi3String)
#undef MIMO_NO_TYPE

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference[], size_t, const size_t[], const fmi3Binary[],
                         size_t) {
  return guarded(instance, [](RunningUnit&) { throw std::runtime_error("pictures are no inputs"); });
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return guarded(instance, [&](RunningUnit& unit) { fmi::keep_state(state, unit.save()); });
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  return guarded(instance, [&](RunningUnit& unit) { unit.load(fmi::bytes_of(state)); });
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return guarded(instance, [&](RunningUnit&) { fmi::free_state(state); });
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, size_t* size) {
  return guarded(instance, [&](RunningUnit&) { *size = fmi::bytes_of(state).size(); });
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  return guarded(instance, [&](RunningUnit&) { fmi::write_state(state, bytes, size); });
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size, fmi3FMUState* state) {
  return guarded(instance, [&](RunningUnit&) { fmi::keep_state(state, Bytes(bytes, bytes + size)); });
}

// What else the standard has, for importers that look for every function.
#define MIMO_REFUSE(name, ...) \
  fmi3Status name(fmi3Instance instance, __VA_ARGS__) { return refused(instance, #name); }
#define MIMO_REFUSE_MODE(name) \
  fmi3Status name(fmi3Instance instance) { return refused(instance, #name); }
using References = const fmi3ValueReference*;

MIMO_REFUSE_MODE(fmi3EnterEventMode)
MIMO_REFUSE_MODE(fmi3EnterConfigurationMode)
MIMO_REFUSE_MODE(fmi3ExitConfigurationMode)
MIMO_REFUSE_MODE(fmi3EvaluateDiscreteStates)
MIMO_REFUSE_MODE(fmi3EnterContinuousTimeMode)
MIMO_REFUSE_MODE(fmi3EnterStepMode)
MIMO_REFUSE(fmi3GetClock, References, size_t, fmi3Clock*)
MIMO_REFUSE(fmi3SetClock, References, size_t, const fmi3Clock*)
MIMO_REFUSE(fmi3GetNumberOfVariableDependencies, fmi3ValueReference, size_t*)
MIMO_REFUSE(fmi3GetVariableDependencies, fmi3ValueReference, size_t*, fmi3ValueReference*, size_t*, fmi3DependencyKind*,
            size_t)
MIMO_REFUSE(fmi3GetDirectionalDerivative, References, size_t, References, size_t, const fmi3Float64*, size_t,
            fmi3Float64*, size_t)
MIMO_REFUSE(fmi3GetAdjointDerivative, References, size_t, References, size_t, const fmi3Float64*, size_t, fmi3Float64*,
            size_t)
MIMO_REFUSE(fmi3GetIntervalDecimal, References, size_t, fmi3Float64*, fmi3IntervalQualifier*)
MIMO_REFUSE(fmi3GetIntervalFraction, References, size_t, fmi3UInt64*, fmi3UInt64*, fmi3IntervalQualifier*)
MIMO_REFUSE(fmi3GetShiftDecimal, References, size_t, fmi3Float64*)
MIMO_REFUSE(fmi3GetShiftFraction, References, size_t, fmi3UInt64*, fmi3UInt64*)
MIMO_REFUSE(fmi3SetIntervalDecimal, References, size_t, const fmi3Float64*)
MIMO_REFUSE(fmi3SetIntervalFraction, References, size_t, const fmi3UInt64*, const fmi3UInt64*)
MIMO_REFUSE(fmi3SetShiftDecimal, References, size_t, const fmi3Float64*)
MIMO_REFUSE(fmi3SetShiftFraction, References, size_t, const fmi3UInt64*, const fmi3UInt64*)
MIMO_REFUSE(fmi3UpdateDiscreteStates, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
            fmi3Float64*)
MIMO_REFUSE(fmi3CompletedIntegratorStep, fmi3Boolean, fmi3Boolean*, fmi3Boolean*)
MIMO_REFUSE(fmi3SetTime, fmi3Float64)
MIMO_REFUSE(fmi3SetContinuousStates, const fmi3Float64*, size_t)
MIMO_REFUSE(fmi3GetContinuousStateDerivatives, fmi3Float64*, size_t)
MIMO_REFUSE(fmi3GetEventIndicators, fmi3Float64*, size_t)
MIMO_REFUSE(fmi3GetContinuousStates, fmi3Float64*, size_t)
MIMO_REFUSE(fmi3GetNominalsOfContinuousStates, fmi3Float64*, size_t)
MIMO_REFUSE(fmi3GetNumberOfEventIndicators, size_t*)
MIMO_REFUSE(fmi3GetNumberOfContinuousStates, size_t*)
MIMO_REFUSE(fmi3GetOutputDerivatives, References, size_t, const fmi3Int32*, fmi3Float64*, size_t)
MIMO_REFUSE(fmi3ActivateModelPartition, fmi3ValueReference, fmi3Float64)

}  // extern "C"
