function number = mimo_scene_add(scene, what, varargin)
% MIMO_SCENE_ADD  Adds something to a scene.
%   number = mimo_scene_add(scene, what, name, value, ...) takes one thing with its properties, which have the names and
%   values of mimo.h's structs. A call that fails leaves the scene as it was. What can be added:
%     'agent'      an infant, or what root says; its number, counted from 1. Properties: name, body, face, vision, touch, ...,
%                  those of the infant in help mimo_create. What is left out is what the scene gives by itself
%     'agents'     all infants that the scene names, with properties in common; how many they are
%     'room'       name (mimo_names('room')): floor, sky and light for a scene that has none
%     'object'     name, shape (1 sphere, 2 capsule, 3 ellipsoid, 4 cylinder, 5 box), size, position, orientation, mass, rgba,
%                  fixed
%     'model'      an MJCF document as an object: name, file or xml, position, orientation, fixed
%     'camera'     a picture more in the observation: name, outputs, height, width, fovy, body, position, look_at
%     'field'      more in the observation: name ('toys/position'), quantity ('body_position', ... of mimo_get, also with _now),
%                  elements (a name or a cell array of names; none of world_gravity), relative_to (the body in whose frame
%                  it is; else the world's)
%     'weld'       body, fastened to the body other or else to the world; pose (7 numbers) or else as they start
%     'lock'       joint, held at value (rad or m)
%     'pose'       joint, which starts at value
%     'skin'       spacing of the touch sensors, m (0: none), of body or else of all; agent
%     'joint'      joint that proprioception reads, in place of all; once more for each further one; agent
%     'limits'     path, gain, noise, delay (s), blur, signal_noise (share of the value) of a sense; agent
%     'motor_limits'  path, gain, noise, delay (s), signal_noise of the way to a motor ('act:left_elbow'), to those of a
%                  part of the body ('left_arm') or, with '', to all; agent
%     'maturity'   eyes and nerves: those of an age (months) or else perfect ones, but for what is given of
%                  help mimo_maturity; with nothing given as the option maturity of mimo_create says; agent
%     'sensory_delay'  seconds by which an agent feels body, or else all of it, late, by touch and joints; agent
%     'sources'    count of bodies that can play at once, 4 unless it is set, and seconds of sound that can wait at each, 4
%     'source_direction'  place and axis (three numbers each, in the frame of body) from where and whereto body plays, and
%                  directivity (0 alike to all sides, 0.5 a cardioid, 1 a figure of eight)
%     'room_temperature'  celsius, of the air and of all that has no temperature of its own
%     'temperature'  celsius, of body and all that hangs on it
%     'material'   name (mimo_names('material')): what body is made of, with all that hangs on it
%     'parameter'  name, value (mimo_parameters)
%   agent is the number of one, 1 unless given. number is 0 for what has none.
number = mimo_mex('scene_add', scene, char(what), varargin{:});
end
