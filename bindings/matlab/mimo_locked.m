function angle = mimo_locked(world, joint)
% MIMO_LOCKED  The angle at which a joint is held.
%   angle = mimo_locked(world, joint) is [] if it is not; of many worlds it is that of the first.
angle = mimo_mex('locked', world, joint);
end
