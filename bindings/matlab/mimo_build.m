function mimo_build(libmimo)
% MIMO_BUILD  Compiles the gateway, once.
%   mimo_build('../libmimo') uses libmimo from a clone in which ./dev build was run; mimo_build() uses the installed one. The
%   compiled gateway goes to the current folder and contains the path of the library.
here = fileparts(mfilename('fullpath'));
sources = dir(fullfile(here, '*.c'));
sources = cellfun(@(name) fullfile(here, name), {sources.name}, 'UniformOutput', false);
flags = {'-lmimo'};
linker = {};
if nargin > 0
  root = whole_path(libmimo);
  folder = fullfile(root, 'build', 'lib');
  if ~exist(folder, 'dir'), error('mimo:NOT_FOUND', 'there is no %s: run ./dev build in %s', folder, root); end
  flags = {['-I' fullfile(root, 'include')], ['-L' folder], '-lmimo'};
  linker = {['-Wl,-rpath,' folder]};
end
if exist('OCTAVE_VERSION', 'builtin')
  mkoctfile('--mex', '-o', 'mimo_mex.mex', sources{:}, flags{:}, linker{:});
else
  if ~isempty(linker), linker = {['LDFLAGS=$LDFLAGS ' linker{1}]}; end
  mex('-R2017b', '-output', 'mimo_mex', sources{:}, flags{:}, linker{:});
end
end

% The gateway contains the path of the library, so it works in any folder.
function folder = whole_path(folder)
if ~exist(folder, 'dir'), error('mimo:NOT_FOUND', 'libmimo is ''%s'', which is no folder', folder); end
before = cd(folder);
folder = pwd();
cd(before);
end
