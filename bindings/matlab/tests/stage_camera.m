% A camera at (0, -2, 0) that looks along +y, as a view of a stage, with further members.
function view = stage_camera(varargin)
  view = struct('position', [0 -2 0], 'rotation', [1 0 0; 0 0 -1; 0 1 0], 'height', 100, 'width', 120, 'fovy', 60, varargin{:});
end
