% Poses of a stage: upright geoms at these places.
function poses = poses_at(place)
  poses = struct('geom_positions', place, 'geom_quaternions', repmat([1 0 0 0], size(place, 1), 1));
end
