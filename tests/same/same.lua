-- The scenario of tests/capi/same.c but its task "own", by the binding that examples/lua makes of interface.json:
-- luajit same.lua EXAMPLES INTERFACE.JSON LIBMIMO.SO
package.path = arg[1] .. "/?.lua"
local ffi = require("ffi")
local mimo = require("mimo")(arg[2], arg[3])

local function hash_of(hash, block, bytes) -- FNV-1a
  for i = 0, bytes - 1 do hash = bit.bxor(hash, 0ULL + block[i]) * 1099511628211ULL end
  return hash
end

local function run(scene)
  local env = mimo.env_make(scene)
  local layout, sizes = mimo.env_layout(env), mimo.new("mimo_layout_info")
  mimo.layout_describe(layout, sizes)
  local bytes, count = tonumber(sizes.block_bytes), tonumber(sizes.actions)
  local block, actions = ffi.new("uint8_t[?]", bytes), ffi.new("float[?]", count)
  local reset, results, reward = mimo.new("mimo_reset_config"), mimo.new("mimo_env_results"), ffi.new("double[1]")
  reset.seeded, reset.seed = 1, 7
  results.reward, results.agent_count = reward, 1
  mimo.env_reset(env, reset, block, bytes)
  local hash, sum = hash_of(14695981039346656037ULL, block, bytes), 0
  for step = 0, 99 do
    for i = 0, count - 1 do actions[i] = ((7 * step + 3 * i) % 21 - 10) / 10 end
    mimo.env_step(env, actions, count, block, bytes, results)
    sum = sum + reward[0]
    hash = hash_of(hash, block, bytes)
  end
  print(("%s %s %.6f"):format(scene, bit.tohex(hash), sum))
end

for _, scene in ipairs({"reach", "standup", "selfbody", "benchmark"}) do run(scene) end

local made, message = pcall(mimo.env_make, "nowhere")
assert(not made and message:find('no scene named "nowhere"', 1, true), message)
