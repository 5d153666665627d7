function directions = mimo_directions(world, field)
% MIMO_DIRECTIONS  The directions of a picture's pixels, foveated or not.
%   directions = mimo_directions(world, 'vision/eye_left') is height x width x 3: unit vectors from the eye or camera to
%   the middle of each pixel, in the camera's frame: x to the right, y up, z backwards. mimo_layout lists names for field.
directions = mimo_mex('directions', world, field);
end
