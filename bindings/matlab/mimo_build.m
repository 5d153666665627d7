function mimo_build(libmimo)
% MIMO_BUILD  Compiles the gateway, once.
%   mimo_build('/home/me/libmimo') takes libmimo from a clone in which ./dev build was run; mimo_build() takes the one
%   that is installed. The compiled gateway goes to the current folder; it finds the library again by itself.
here = fileparts(mfilename('fullpath'));
sources = dir(fullfile(here, '*.c'));
sources = cellfun(@(name) fullfile(here, name), {sources.name}, 'UniformOutput', false);
flags = {'-lmimo'};
linker = '';
if nargin > 0
  folder = fullfile(libmimo, 'build', 'lib');
  flags = {['-I' fullfile(libmimo, 'include')], ['-L' folder], '-lmimo'};
  linker = ['-Wl,-rpath,' folder];
end
if exist('OCTAVE_VERSION', 'builtin')
  mkoctfile('--mex', '-o', 'mimo_mex.mex', sources{:}, flags{:}, linker);
else
  mex('-R2017b', '-output', 'mimo_mex', sources{:}, flags{:}, ['LDFLAGS=$LDFLAGS ' linker]);
end
end
