function angle = mimo_locked(world, joint)
% MIMO_LOCKED  The angle at which a joint is held, [] if it is not; of many worlds the first.
angle = mimo_mex('locked', world, joint);
end
