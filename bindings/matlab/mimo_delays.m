function delays = mimo_delays(world, field)
% MIMO_DELAYS  How late the elements of a field come.
%   delays = mimo_delays(world, 'touch/force') is an array of the field's size: seconds, 0 for what is sensed at once.
%   Of many worlds, and after a reset to another age, it is that of the first one as it was made. mimo_layout lists
%   names for field.
delays = mimo_mex('delays', world, field);
end
