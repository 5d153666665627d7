function converted = mimo_convert(what, values, axes)
% MIMO_CONVERT  Points and directions in an engine's frame.
%   converted = mimo_convert(what, values, axes): what is 'points' (for example of touch sensors) or 'directions' (forces,
%   normals), values are 3 x n in libmimo's frame, axes is 'unity', 'unreal', 'godot' or 'gltf'.
converted = mimo_mex('convert', what, values, axes);
end
