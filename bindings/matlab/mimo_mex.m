function varargout = mimo_mex(varargin)
% MIMO_MEX  The gateway to libmimo, which mimo_build compiles. This file finds it if it is not on the path yet.
%   varargout = mimo_mex(command, value, ...) is for the other functions of this folder, whose help explains them.
name = ['mimo_mex.' mexext()];
folders = [{pwd()}, strsplit(path(), pathsep())];
there = cellfun(@(folder) exist(fullfile(folder, name), 'file') > 0, folders);
if ~any(there)
  error('mimo:UNSUPPORTED', ...
        'the gateway %s is neither in the current folder nor on the path: mimo_build compiles it, addpath finds it', name);
end
% It is behind this folder on the path: it goes before it.
folder = folders{find(there, 1)};
if strcmp(folder, fileparts(mfilename('fullpath')))
  error('mimo:UNSUPPORTED', 'the gateway %s in %s cannot be loaded; mimo_build compiles it anew', name, folder);
end
addpath(folder);
rehash();
[varargout{1:nargout}] = feval('mimo_mex', varargin{:});
end
