function names = mimo_names(world, kind)
% MIMO_NAMES  Names of all things of a kind: 'body', 'joint', 'geom', 'site', 'camera', 'actuator' or 'sensor'.
names = mimo_mex('names', world, kind);
end
