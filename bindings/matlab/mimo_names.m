function names = mimo_names(world, kind)
% MIMO_NAMES  Names of all things of a kind.
%   names = mimo_names(world, kind) is a cell column; '' where the model has no name. Kinds: 'body', 'joint', 'geom', 'site',
%   'camera', 'actuator', 'sensor', 'light', 'agent', 'face', 'warning'.
%   names = mimo_names(kind) lists what the library knows. Kinds: 'scene', 'room', 'task', 'face', 'material'.
if nargin < 2, names = mimo_mex('known', world); else, names = mimo_mex('names', world, kind); end
end
