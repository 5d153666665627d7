function known = mimo_supports(name)
% MIMO_SUPPORTS  Whether the loaded library knows something of mimo.h.
%   known = mimo_supports(name) is true or false: of a function ('mimo_batch_step'), a constant ('MIMO_SITE_VELOCITY'), a struct
%   ('mimo_field') or a member of one ('mimo_field.period').
known = mimo_mex('supports', name);
end
