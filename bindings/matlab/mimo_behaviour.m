function behaviour = mimo_behaviour(scene)
% MIMO_BEHAVIOUR  What the infant of a scene is to do.
%   behaviour = mimo_behaviour(scene) is a struct of about, measure, unit, threshold, at_most (true: the measure reaches the
%   threshold from above), conditions, hold_seconds, episode_seconds; norm_early, norm_age and norm_late (months, 0 where not
%   known), norm and norm_source. The scene of mimo_scene is one whose task is "behaviour": mimo_scene('sit').
behaviour = mimo_mex('behaviour', scene);
end
