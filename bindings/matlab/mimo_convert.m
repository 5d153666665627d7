function converted = mimo_convert(what, values, axes)
% MIMO_CONVERT  Places and directions in an engine's frame.
%   converted = mimo_convert(what, values, axes): what is 'points' (of touch sensors, for example) or 'directions' (forces,
%   normals), values are 3 x n in our frame, axes is 'unity', 'unreal', 'godot' or 'gltf'.
converted = mimo_mex('convert', what, values, axes);
end
