function [observation, reward, terminated, truncated, info] = mimo_step(world, actions, precision)
% MIMO_STEP  Goes one step on.
%   [observation, reward, terminated, truncated, info] = mimo_step(world, actions): actions of all agents, clipped to their
%   bounds (mimo_bounds), a column a world; [] leaves the motors as they are. reward, terminated and truncated are agents x
%   worlds. info is a struct of
%     outcome        agents x worlds: 1 for success, -1 for failure, 0 for neither
%     terms          what rewards are the sums of, terms x worlds; mimo_layout names them
%     was_reset      worlds that started an episode in this step (option autoreset)
%     final_written  worlds whose last observation before that is in mimo_observation(world, precision, 'final') (autoreset same_step)
%   [...] = mimo_step(world, actions, precision): 'double' or 'single', as in mimo_observation.
if nargin < 3, precision = 'double'; end
[reward, terminated, truncated, info] = mimo_mex('step', world, actions);
observation = mimo_observation(world, precision);
end
