function angle = mimo_locked(world, joint)
% MIMO_LOCKED  The angle at which a joint is locked.
%   angle = mimo_locked(world, joint) is [] if the joint is not locked. Of several worlds it reads the first.
angle = mimo_mex('locked', world, joint);
end
