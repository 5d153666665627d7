function world = mimo_create(scene, varargin)
% MIMO_CREATE  A simulated world, or many of them that are stepped together.
%   world = mimo_create('reach') returns a number for the other functions. It stays valid after "clear"; mimo_close frees it.
%   scene is one of mimo_names('scene'), or the path of an MJCF file, "room.xml".
%   Errors have identifiers: mimo:NOT_FOUND, mimo:INVALID_ARGUMENT, mimo:BAD_HANDLE, ...
%   world = mimo_create(scene, ...) also takes a scene from mimo_scene. Then it takes the options of simulation, pictures and
%   many worlds only; the scene contains the others.
%
%   world = mimo_create('reach', name, value, ...) changes the scene's defaults. help mimo_options explains all options:
%     the infant   vision, touch, proprioception, vestibular, hearing, reflexes, voice, actuation, acts, body, face, ...
%     its age      age (months, 0 to 24), sex, percentile, growth, maturity, ...
%     no infant    root (with the body 'scene': a body of the MJCF file with its children; 'world': the whole model),
%                  vestibular_at
%     simulation   task, frame_skip, max_steps, step_contacts, timing, ...
%     pictures     renderer, render, samples, render_threads
%     many worlds  worlds, threads, autoreset, restart_failed; ages (months: the infants of world i have age number i, and the
%                  ages repeat; NaN: as the scene says). The worlds are the last dimension of all arrays
%     documents    max_elements, confined, ... and model_dir
%   and these, which have no counterpart in help mimo_options:
%     parameters   a cell array of names and values, {'reach/success_reward', 5; ...}: mimo_parameters
%     limits, motor_limits, objects, models, cameras, fields
%                  struct arrays; their members are the options of mimo_scene_add for 'limits', 'object', ... A camera with
%                  look_at is a new one. In struct() a cell array goes into braces, {{'ball', 'cup'}}
%   Words stand for the constants of mimo.h, and several of them go into a cell array:
%     mimo_create('reach', 'touch', {'force', 'slip'}, 'vision', {}, 'actuation', 'muscle')
if ~isnumeric(scene), scene = char(scene); end
world = mimo_mex('create', scene, varargin{:});
end
