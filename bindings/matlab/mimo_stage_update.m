function mimo_stage_update(stage, varargin)
% MIMO_STAGE_UPDATE  Replaces parts of a stage.
%   mimo_stage_update(stage, name, value, ...) replaces the parts that are given, all at once, and leaves the others as they
%   are: other colours, lights, sizes. help mimo_stage lists the parts. If one is wrong, the stage stays as it is.
mimo_mex('stage_update', stage, varargin{:});
end
