function mimo_send(world, actions)
% MIMO_SEND  Starts a step and returns at once, for something else to be done meanwhile.
%   mimo_send(world, actions) takes actions as mimo_step. Until mimo_receive the worlds can only be closed.
mimo_mex('send', world, actions);
end
