function [observation, reward, terminated, truncated, info] = mimo_step(world, actions, precision)
% MIMO_STEP  Makes one step.
%   [observation, reward, terminated, truncated, info] = mimo_step(world, actions): actions of all agents, clipped to their
%   bounds (mimo_bounds), a column for each world; [] does not change the motors. reward, terminated and truncated are agents x
%   worlds. info is a struct of
%     outcome        agents x worlds: 1 for success, -1 for failure, 0 for neither
%     terms          the terms that add up to rewards, terms x worlds; mimo_layout names them
%     was_reset      whether this step started an episode in a world (option autoreset)
%     final_written  whether mimo_observation(world, precision, 'final') has the world's last observation of the episode that
%                    ended (autoreset 'same_step')
%   [...] = mimo_step(world, actions, precision): 'double' or 'single', as in mimo_observation.
if nargin < 3, precision = 'double'; end
[reward, terminated, truncated, info] = mimo_mex('step', world, actions);
observation = mimo_observation(world, precision);
end
