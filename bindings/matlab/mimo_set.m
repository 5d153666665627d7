function mimo_set(world, quantity, names, values)
% MIMO_SET  Writes a quantity by name, or of all elements of its kind.
%   mimo_set(world, quantity, names, values) takes values as mimo_get returns them, double or single: a column for each world,
%   or one column for all. With names [] it writes all elements. help mimo_quantities says which quantities are writable, and
%   which of them outlive resets (W).
mimo_mex('set', world, quantity, names, values);
end
