function values = mimo_receptors(world, field, quantity)
% MIMO_RECEPTORS  The skin receptors of a field.
%   values = mimo_receptors(world, 'touch/force', 'position') has a row for each receptor, in the order of the field's rows.
%   values = mimo_receptors(world, field, quantity): quantities are
%     body      id of its body: mimo_names(world, 'body') has the name at id + 1
%     geom      id of the geom on whose surface it lies: mimo_names(world, 'geom') has the name at id + 1
%     position  three numbers, m, in the frame of its body
%     frame     nine numbers, in the frame of its body: outward normal, first tangent, second tangent
%   mimo_layout lists the fields and says which have receptors.
values = mimo_mex('receptors', world, field, quantity);
end
