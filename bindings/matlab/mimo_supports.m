function known = mimo_supports(name)
% MIMO_SUPPORTS  Whether the loaded library knows a name of mimo.h.
%   known = mimo_supports(name) is true or false for a function ('mimo_batch_step'), a constant ('MIMO_SITE_VELOCITY'), a struct
%   ('mimo_field') or a member of a struct ('mimo_field.period').
known = mimo_mex('supports', name);
end
