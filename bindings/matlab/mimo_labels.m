function labels = mimo_labels(world, field)
% MIMO_LABELS  Names of the elements of a field.
%   labels = mimo_labels(world, 'proprioception/position') is a cell array of the field's size: names of joints, sensors or
%   motors, "robot:left_elbow"; '' in pictures and touch. mimo_layout lists names for field.
labels = mimo_mex('labels', world, field);
end
