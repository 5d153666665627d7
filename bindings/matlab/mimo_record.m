function mimo_record(world, file, varargin)
% MIMO_RECORD  Records a world's steps into an HDF5 file, until mimo_record_end or mimo_close.
%   mimo_record(world, 'run.h5') keeps actions, rewards, joints, proprioception and vestibular sense of each step, and
%   states from which mimo_replay goes on. h5read reads them. A recording that is there stays, and is an error.
%   mimo_record(world, file, name, value, ...) sets options: keep ('all', 'none', or senses and fields with commas between
%   them), state_seconds (simulated, between states), flush_seconds (real, until all is on its way to the disk), compression
%   (0 to 9), configuration (a text of yours), seed, hdf5 (path of the HDF5 library), replace (1: a recording that
%   is there and that no program is using is replaced); index: which of many worlds.
index = 1;
at = find(strcmp(varargin(1:2:end), 'index'), 1);
if ~isempty(at)
  index = varargin{2 * at};
  varargin(2 * at - 1:2 * at) = [];
end
mimo_mex('record', world, file, index, varargin{:});
end
