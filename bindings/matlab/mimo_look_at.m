function errors = mimo_look_at(world, point, how, index)
% MIMO_LOOK_AT  Makes the infant look at a point (world, m) at once: with its 'eyes' (default), or its 'head' first.
%   Gives the angles by which the left and the right eye miss it, rad. index: which of many worlds.
if nargin < 3, how = 'eyes'; end
if nargin < 4, index = 1; end
errors = mimo_mex('look_at', world, point, how, index);
end
