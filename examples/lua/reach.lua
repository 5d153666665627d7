-- An infant reaches for a ball for ten seconds, with random actions: luajit reach.lua [INTERFACE.JSON] [LIBMIMO.SO]
package.path = arg[0]:match(".*/") .. "?.lua;" .. package.path
local ffi = require("ffi")
local mimo = require("mimo")(arg[1] or "/usr/share/mimo/interface.json", arg[2] or "libmimo.so.1")

local env = mimo.env_make("reach")
local layout = mimo.env_layout(env)
local sizes = mimo.new("mimo_layout_info")
mimo.layout_describe(layout, sizes)

local block = ffi.new("uint8_t[?]", sizes.block_bytes)
local actions = ffi.new("float[?]", sizes.actions)
local reset = mimo.new("mimo_reset_config")
reset.seeded, reset.seed = 1, 7
mimo.env_reset(env, reset, block, sizes.block_bytes)
math.randomseed(7)
for _ = 1, 1000 do
  for i = 0, tonumber(sizes.actions) - 1 do actions[i] = 2 * math.random() - 1 end
  mimo.env_step(env, actions, sizes.actions, block, sizes.block_bytes, nil)
end

local field, total = mimo.new("mimo_field"), 0
for index = 0, tonumber(sizes.fields) - 1 do
  mimo.layout_field(layout, index, field)
  assert(field.dtype == mimo.FieldType.F32)
  local values, sum = ffi.cast("const float *", block + field.offset), 0
  for i = 0, tonumber(field.bytes) / 4 - 1 do sum = sum + values[i] end
  print(("%-28s %12.6f"):format(ffi.string(field.name), sum))
  total = total + sum
end
print(("sum of the observation       %12.6f"):format(total))
