function mimo_record(world, file, varargin)
% MIMO_RECORD  Records a world's steps into an HDF5 file, until mimo_record_end or mimo_close.
%   mimo_record(world, 'run.h5') keeps actions, rewards, joints, proprioception and vestibular sense of each step, and
%   states for mimo_replay. h5read reads the file. An existing recording is kept, and is an error.
%   mimo_record(world, file, name, value, ...) sets options: keep ('all', 'none', or senses and fields separated by commas),
%   state_seconds, flush_seconds, compression, configuration, seed, hdf5 and replace, which help mimo_options explains; and
%   index, the number of the world among several.
index = 1;
at = find(strcmp(varargin(1:2:end), 'index'), 1);
if ~isempty(at)
  index = varargin{2 * at};
  varargin(2 * at - 1:2 * at) = [];
end
mimo_mex('record', world, file, index, varargin{:});
end
