function [rgb, depth, segmentation] = mimo_stage_draw(stage, poses, view)
% MIMO_STAGE_DRAW  Draws a stage.
%   rgb = mimo_stage_draw(stage, poses, view) is height x width x 3, uint8, for imshow.
%     poses   a struct of where things are, with a row for each: geom_positions (n x 3, m), geom_quaternions (n x 4) or
%             geom_rotations (n x 9, row by row), likewise of sites; light_positions, light_directions; vertices of surfaces;
%             paths of tendons; extra_forms, extra_sizes, extra_positions, ... of shapes of this picture alone
%     view    a struct: position (3, m) and rotation (3 x 3; its columns are right, up and backward) of the camera, height,
%             width, fovy, ...: help mimo_options
%   [rgb, depth, segmentation] = mimo_stage_draw(stage, poses, view) also returns the depth along the camera's axis, m, and for
%   each pixel the number of the object, counted from 0, and its object_type (height x width x 2); -1 where nothing is. Outputs
%   that are not used are not drawn.
%   [...] = mimo_stage_draw(stage, poses, views) draws an array of views at once, on the stage's threads, into cells. Poses
%   may be an array as well; the member pose of a view says which of them it shows, 1 by default.
drawn = cell(1, max(nargout, 1));
[drawn{:}] = mimo_mex('stage_draw', stage, poses, view);
drawn(end + 1:3) = {[]};
[rgb, depth, segmentation] = drawn{:};
end
