-- The ranges that interface.json gives are those of the library: a member below or above its own is refused, and the
-- message names it. luajit ranges.lua EXAMPLES INTERFACE.JSON LIBMIMO.SO
package.path = arg[1] .. "/?.lua"
local ffi = require("ffi")
local mimo, interface = require("mimo")(arg[2], arg[3])

local scene = mimo.new("mimo_scene_config")
scene.name = "free"
local room = mimo.scene_create(scene)
mimo.scene_add_agent(room, nil, nil)
local env = mimo.env_make("reach")
local stage = mimo.stage_create(mimo.new("mimo_stage_config"))
local agent = mimo.new("mimo_agent_config")
agent.name = "another"

-- What reads each struct.
local readers = {
  mimo_agent_config = function(config)
    config.name = "another"
    mimo.scene_add_agent(room, config, nil)
  end,
  mimo_batch_config = function(config) mimo.batch_create(room, nil, config) end,
  mimo_camera_config = function(config)
    config.name, config.outputs = "camera", mimo.Vision.RGB
    mimo.scene_add_camera(room, config)
  end,
  mimo_env_config = function(config) mimo.env_create(room, config) end,
  mimo_growth = function(growth)
    if growth.physiological_age ~= 18 then growth.matures_apart = 1 end
    agent.growth = growth
    mimo.scene_add_agent(room, agent, nil)
  end,
  mimo_limits = function(limits) mimo.scene_limit_sense(room, 0, "touch", limits) end,
  mimo_maturity = function(maturity) mimo.scene_set_maturity(room, 0, maturity) end,
  mimo_mesh = function(mesh) mimo.env_mesh(env, 0, mesh) end,
  mimo_model_config = function(config)
    config.name, config.xml = "thing", "<mujoco><worldbody><body/></worldbody></mujoco>"
    mimo.scene_add_model(room, config)
  end,
  mimo_object_config = function(config)
    config.name, config.shape, config.size[0] = "thing", mimo.Shape.SPHERE, 1
    mimo.scene_add_object(room, config)
  end,
  mimo_picture_config = function(config) mimo.env_render(env, config, mimo.new("mimo_picture")) end,
  mimo_recorder_config = function(config) mimo.recorder_open(env, "/nowhere/run.h5", config) end,
  mimo_scene_config = function(config)
    config.name = "free"
    mimo.scene_create(config)
  end,
  mimo_sense = function(sense)
    sense.interface_version, sense.name = mimo.MIMO_SENSE_INTERFACE, "own"
    mimo.scene_add_sense(room, 0, sense)
  end,
  mimo_stage_air = function(air)
    local config = mimo.new("mimo_stage_config")
    config.air = air
    mimo.stage_create(config)
  end,
  mimo_stage_view = function(view)
    view.position, view.rotation = ffi.new("double[3]"), ffi.new("double[9]", {1, 0, 0, 0, 1, 0, 0, 0, 1})
    local poses = mimo.new("mimo_stage_poses")
    mimo.stage_draw(stage, ffi.new("const mimo_stage_poses *[1]", {poses}), 1,
                    ffi.new("const mimo_stage_view *[1]", {view}), 1)
  end,
  mimo_senses_config = false, -- needs a model and data of MuJoCo
}

local tried, wrong = 0, {}
local function try(struct, member, value)
  local config = mimo.new(struct.name)
  local whole = member.type:match("int") or member.type == "size_t"
  if whole and (value < 0 or value ~= math.floor(value)) then return end
  if member.array > 0 then config[member.name][0] = value else config[member.name] = value end
  local done, message = pcall(readers[struct.name], config)
  tried = tried + 1
  if done or not message:find(member.name, 1, true) then
    wrong[#wrong + 1] = ("%s.%s = %g: %s"):format(struct.name, member.name, value, done and "it is taken" or message)
  end
end

for _, struct in ipairs(interface.structs) do
  for _, member in ipairs(struct.members) do
    if struct.init and member.range and readers[struct.name] ~= false then
      assert(readers[struct.name], "nothing here reads " .. struct.name)
      local low, high = member.range[1], member.range[2]
      if low ~= 0 then try(struct, member, low - (low > 0 and low / 2 or 0.5)) else try(struct, member, -0.001) end
      try(struct, member, member.type == "double" and high * 1.01 or high + 1)
    end
  end
end
print(table.concat(wrong, "\n"))
print(tried .. " values beyond a range, " .. #wrong .. " of them not refused by the member's name")
os.exit(#wrong == 0 and tried > 60)
