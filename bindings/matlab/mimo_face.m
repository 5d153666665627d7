function name = mimo_face(world, name)
% MIMO_FACE  The face that the infant shows.
%   name = mimo_face(world) returns its name; mimo_face(world, 'fear') sets another face, in all worlds. Faces are "neutral",
%   "enjoyment", "sadness", "surprise", "disgust", "anger" and "fear".
if nargin < 2, name = mimo_mex('face', world); else, name = mimo_mex('face', world, name); end
end
