function body = mimo_body_of(world, kind, name)
% MIMO_BODY_OF  The body to which an element belongs.
%   body = mimo_body_of(world, kind, name) is the name of the body of a 'joint', 'geom', 'site' or 'camera', or of the parent of
%   a 'body'.
body = mimo_mex('body_of', world, kind, name);
end
