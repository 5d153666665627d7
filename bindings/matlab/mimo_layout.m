function layout = mimo_layout(world)
% MIMO_LAYOUT  Describes observations, actions and rewards.
%   layout = mimo_layout(world) is a struct that never changes. For several worlds it describes each of them:
%     fields       struct array: name ("touch/force"), member (its name in observations, "touch_force"), type (the library's),
%                  size, unit, frame, offset and bytes in the block, low, high, time, period, receptors (the number of skin
%                  receptors, one for each row; 0 if it is not a skin field) and sample_rate (of sound, samples per second, the
%                  oldest first; 0 if it is not a sound). time is [start end]: the time to which a step's value belongs, in
%                  seconds after the step's end; [0 0] for the end itself, negative for values with a delay or of the start of
%                  the last physics step. period is the time between new values, s
%     actions      struct array: name ("act:left_elbow"), unit, agent, low, high
%     terms        struct array: name, agent; of the terms that mimo_step returns
%     agents       the number of agents
%     block_bytes  the length of an observation in the library
%     step_seconds the simulated time of a step
%   Agents are counted from 1.
layout = mimo_mex('layout', world);
end
