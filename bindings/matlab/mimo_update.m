function mimo_update(world)
% MIMO_UPDATE  Brings the poses of bodies, and of what they carry, up to where the joints are now.
%   mimo_update(world): after a step mimo_get gives them as they were at the start of its last physics step. The trajectory
%   stays as it was.
mimo_mex('update', world);
end
