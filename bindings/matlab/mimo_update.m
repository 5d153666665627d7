function mimo_update(world)
% MIMO_UPDATE  Recomputes the poses of bodies, and of everything on them, from the current joints.
%   mimo_update(world): after a step mimo_get returns poses as they were at the start of its last physics step. The trajectory
%   does not change.
mimo_mex('update', world);
end
