function version = mimo_version()
% MIMO_VERSION  Versions of the loaded library.
%   version = mimo_version() is a struct of library ("1.0.0"), mujoco ("2.2.2"), api (of its mimo.h, a number: 1002 is 1.2) and
%   abi (a number).
version = mimo_mex('version');
end
