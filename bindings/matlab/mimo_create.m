function world = mimo_create(scene)
% MIMO_CREATE  A simulated world of a built-in scene: "benchmark", "reach", "standup", "selfbody", "free".
%   world = mimo_create('reach') gives a number for the other functions. It stays good after "clear"; close it by
%   mimo_close. Errors have identifiers: mimo:NOT_FOUND, mimo:INVALID_ARGUMENT, mimo:BAD_HANDLE, ...
world = mimo_mex('create', char(scene));
end
