function mimo_send(world, actions)
% MIMO_SEND  Starts a step and returns at once, so that MATLAB can do something else meanwhile.
%   mimo_send(world, actions) takes actions as mimo_step does. Until mimo_receive the worlds can only be closed.
mimo_mex('send', world, actions);
end
