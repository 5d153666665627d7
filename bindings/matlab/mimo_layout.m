function layout = mimo_layout(world)
% MIMO_LAYOUT  What worlds observe, act with and are rewarded for.
%   layout = mimo_layout(world) is a struct that never changes, the same for each of many worlds:
%     fields       struct array: name ("touch/force"), member (its name in observations, "touch_force"), type (the library's),
%                  size, unit, frame, offset and bytes in the block, low, high, time, period and receptors (on how many it
%                  reports, row by row; 0 where it is not of skin). time is [start end]: when what a step gives is true, s
%                  after the step's end; [0 0] then, negative for what is late or belongs to the start of the last physics
%                  step. period: s from one new value to the next. sample_rate: of sound, samples a second, the oldest
%                  first; 0 where it is no sound
%     actions      struct array: name ("act:left_elbow"), unit, agent, low, high
%     terms        struct array: name, agent; of the terms that mimo_step gives
%     agents       how many
%     block_bytes  how long an observation is, as the library writes it
%   Agents are counted from 1.
layout = mimo_mex('layout', world);
end
