% A stage of one red sphere of radius 0.5, with further parts. The light of the camera makes no highlight.
function stage = red_ball(varargin)
  stage = mimo_stage('geoms', struct('forms', {{'sphere'}}, 'sizes', [0.5 0 0], 'colors', [1 0 0 1], 'object_type', 5), ...
                     'air', struct('specular', [0 0 0]), varargin{:});
end
