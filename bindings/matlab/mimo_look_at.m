function errors = mimo_look_at(world, point, how, index, agent)
% MIMO_LOOK_AT  Makes the infant look at a point (world, m) at once.
%   errors = mimo_look_at(world, point) turns its eyes and returns the angles by which the left and the right eye miss it, rad.
%   errors = mimo_look_at(world, point, 'head') turns the head first, so that the eyes have to turn little.
%   errors = mimo_look_at(worlds, point, how, index, agent) does this in one of several worlds, with one of several agents; how is
%   'eyes' or 'head'.
if nargin < 3, how = 'eyes'; end
if nargin < 4, index = 1; end
if nargin < 5, agent = 1; end
errors = mimo_mex('look_at', world, point, how, index, agent);
end
