function [joints, angles, errors] = mimo_look_angles(world, point, how, index, agent)
% MIMO_LOOK_ANGLES  Angles of the joints that make the infant look at a point (world, m). Nothing moves.
%   [joints, angles, errors] = mimo_look_angles(world, point) returns names of the eyes' joints, their angles (rad), and the
%   angles by which the left and the right eye miss the point because of their range, rad.
%   [...] = mimo_look_angles(world, point, how, index, agent): as in mimo_look_at.
if nargin < 3, how = 'eyes'; end
if nargin < 4, index = 1; end
if nargin < 5, agent = 1; end
[joints, angles, errors] = mimo_mex('look_angles', world, point, how, index, agent);
end
