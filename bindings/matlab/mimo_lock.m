function mimo_lock(world, joint, angle)
% MIMO_LOCK  Holds a joint at an angle (rad), softly, from the next step on, in all worlds; with [] it lets the joint go.
mimo_mex('lock', world, joint, angle);
end
