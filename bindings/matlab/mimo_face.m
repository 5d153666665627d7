function name = mimo_face(world, name)
% MIMO_FACE  The face that the infant shows.
%   name = mimo_face(world) gives its name; mimo_face(world, 'fear') gives the infant another, in all worlds.
%   "neutral", "enjoyment", "sadness", "surprise", "disgust", "anger", "fear".
if nargin < 2, name = mimo_mex('face', world); else, name = mimo_mex('face', world, name); end
end
