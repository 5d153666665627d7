-- libmimo in LuaJIT: a binding that is made of interface.json when it is loaded, so it has all that the library has.
--   local mimo = require("mimo")("interface.json", "libmimo.so.1")
--   mimo.env_step(env, ...)       a function, without "mimo_"; one that fails raises an error with the library's message
--   mimo.new("mimo_env_config")   a struct with its defaults, or with its struct_size set
--   mimo.Touch.FORCE              a constant of an enumeration; others are mimo.MIMO_NOW and so on
local ffi = require("ffi")

-- JSON, as far as interface.json goes: no escapes but those of one letter.
local function decode(text)
  local at, value = 1, nil
  local letters = {n = "\n", t = "\t"}

  local function quoted()
    local from = at + 1
    at = from
    while text:sub(at, at) ~= '"' do
      at = text:find('["\\]', text:sub(at, at) == "\\" and at + 2 or at + 1)
    end
    at = at + 1
    return (text:sub(from, at - 2):gsub("\\(.)", function(letter) return letters[letter] or letter end))
  end

  -- The elements of a list or an object up to its closing bracket, each read by a function.
  local function elements(closing, read)
    local found = {}
    at = text:find("%S", at + 1)
    while text:sub(at, at) ~= closing do
      read(found)
      at = text:find("[^%s,]", at)
    end
    at = at + 1
    return found
  end

  function value()
    at = text:find("%S", at)
    local first = text:sub(at, at)
    if first == '"' then return quoted() end
    if first == "[" then return elements("]", function(list) list[#list + 1] = value() end) end
    if first == "{" then
      return elements("}", function(object)
        local key = quoted()
        at = text:find(":", at, true) + 1
        object[key] = value()
      end)
    end
    local word = text:match("^[%w.+-]+", at)
    at = at + #word
    if word == "null" then return nil end
    return word == "true" or (word ~= "false" and tonumber(word))
  end

  return value()
end

-- The declarations in C: names of structs first, as they refer to each other.
local function declarations(api)
  local lines = {}
  local function add(...) lines[#lines + 1] = table.concat({...}) end
  local function arguments(callable)
    local list = {}
    for i, parameter in ipairs(callable.parameters) do list[i] = parameter.type .. " " .. parameter.name end
    return "(" .. table.concat(list, ", ") .. ");"
  end
  for _, kind in ipairs({api.handles, api.structs}) do
    for _, one in ipairs(kind) do add("typedef struct ", one.name, " ", one.name, ";") end
  end
  for _, one in ipairs(api.typedefs) do add("typedef ", one.c_type, " ", one.name, ";") end
  for _, one in ipairs(api.callbacks) do add("typedef ", one.returns, " (*", one.name, ")", arguments(one)) end
  for _, one in ipairs(api.structs) do
    add("struct ", one.name, " {")
    for _, member in ipairs(one.members) do
      add(member.type, " ", member.name, member.array > 0 and "[" .. member.array .. "]" or "", ";")
    end
    add("};")
  end
  for _, one in ipairs(api.functions) do add(one.returns, " ", one.name, arguments(one)) end
  return table.concat(lines, "\n")
end

-- A function that raises an error instead of returning a status. One whose last argument receives a handle returns it,
-- and Lua's collector destroys it where that is the caller's duty.
local function wrapped(library, declared, named)
  local call, count = library[declared.name], #declared.parameters
  if declared.returns ~= "mimo_status" then return call end
  local handle = count > 0 and declared.parameters[count].type:match("^(.*mimo_%w+ %*)%*$")
  local kind = handle and handle:match("^mimo_%w+")
  local destroy = kind and library[(named[kind .. "_destroy"] or named[kind .. "_close"]).name]
  return function(...)
    local given = {...}
    local slot = handle and ffi.new(handle .. "[1]")
    if slot then given[count] = slot end
    if call(unpack(given, 1, count)) ~= 0 then error(ffi.string(library.mimo_last_error()), 2) end
    return slot and (destroy and ffi.gc(slot[0], destroy) or slot[0])
  end
end

return function(interface, path)
  local file = assert(io.open(interface))
  local api = decode(file:read("*a"))
  file:close()
  ffi.cdef(declarations(api))
  local library, mimo, named = ffi.load(path), {}, {}
  assert(library.mimo_abi_version() == api.abi, "the library has another ABI version than " .. interface)
  for _, one in ipairs(api.functions) do named[one.name] = one end
  for name, one in pairs(named) do mimo[name:sub(6)] = wrapped(library, one, named) end
  for _, one in ipairs(api.constants) do mimo[one.name] = one.value end
  for _, enum in ipairs(api.enums) do
    mimo[enum.name] = {}
    for _, name in ipairs(enum.constants) do
      local word = name:sub(1, #enum.prefix) == enum.prefix and name:sub(#enum.prefix + 1) or name:sub(6)
      mimo[enum.name][word] = mimo[name]
    end
  end
  for _, one in ipairs(api.structs) do
    named[one.name] = one
    assert(ffi.sizeof(one.name) == one.size, one.name .. " has another size than " .. interface .. " says")
  end
  function mimo.new(name)
    local struct, init = ffi.new(name), named[name].init
    if init then
      mimo[init:sub(6)](struct, ffi.sizeof(name))
    elseif named[name].sized then
      struct.struct_size = ffi.sizeof(name)
    end
    return struct
  end
  return mimo, api
end
