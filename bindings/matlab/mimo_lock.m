function mimo_lock(world, joint, angle)
% MIMO_LOCK  Holds a joint at an angle, softly.
%   mimo_lock(world, joint, angle) locks it from the next step on, in all worlds (rad; m for a slide).
%   mimo_lock(world, joint, []) releases it. mimo_names(world, 'joint') lists the joints.
mimo_mex('lock', world, joint, angle);
end
