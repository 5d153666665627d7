function delays = mimo_delays(world, field)
% MIMO_DELAYS  The delays of a field's elements.
%   delays = mimo_delays(world, 'touch/force') is an array of the field's size: seconds, 0 for no delay. For several worlds, and
%   after a reset to another age, it has the delays of the first world as it was made. mimo_layout lists names for field.
delays = mimo_mex('delays', world, field);
end
