function values = mimo_receptors(world, field, quantity)
% MIMO_RECEPTORS  Where the sensors of a field are, on the skin.
%   values = mimo_receptors(world, 'touch/force', 'position') has a row for each sensor, in the order of the field's rows.
%   values = mimo_receptors(world, field, quantity): quantities are
%     body      the body that it sits on, by its id: mimo_names(world, 'body') has it at id + 1
%     geom      the geom whose surface it lies on, likewise
%     position  three numbers, m, in the frame of its body
%     frame     nine numbers, in the frame of its body: outward normal, first tangent, second tangent
%   mimo_layout lists the fields and says which have receptors.
values = mimo_mex('receptors', world, field, quantity);
end
