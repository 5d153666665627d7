function number = mimo_scene_add(scene, what, varargin)
% MIMO_SCENE_ADD  Adds something to a scene.
%   number = mimo_scene_add(scene, what, name, value, ...) adds one thing with its options. If it fails, the scene stays
%   unchanged. help mimo_options explains the options of 'agent', 'object', 'model', 'camera', 'field', 'limits' and 'maturity'.
%     'agent'      an infant, or the part of the model that root names. number is the agent's number, counted from 1. Options
%                  that are left out have the scene's defaults
%     'agents'     all infants that the scene names, with options in common; number is how many there are
%     'room'       name (mimo_names('room')): floor, sky and light for a scene that has none
%     'object'     a rigid object of one shape: name, shape, size, position, mass, ...
%     'model'      an MJCF document as an object: name, file or xml, position, ...
%     'camera'     one more picture in the observation: name, outputs, height, width, ...; with look_at a new camera
%     'field'      one more field in the observation: name ('toys/position'), quantity (help mimo_quantities, also with _now),
%                  elements (a name or a cell array of names; none for world_gravity), relative_to (the body in whose frame
%                  the values are; by default the world)
%     'weld'       fastens body to the body other, or to the world; pose (7 numbers), by default as they start
%     'lock'       holds joint at value (rad or m)
%     'pose'       joint starts at value
%     'skin'       spacing of the touch sensors, m (0: none), of body, by default of all bodies; agent
%     'joint'      a joint that proprioception reads in place of all joints; another call adds another joint; agent
%     'limits'     limits of a sense: path, gain, noise, delay, ...; agent
%     'motor_limits'  the same for a motor ('act:left_elbow'), for the motors of a part of the body ('left_arm') or, with '',
%                  for all motors, without blur; agent
%     'maturity'   eyes and nerves: age (months) gives those of an age, the default is perfect ones; further options change
%                  single numbers. Without any option the maturity follows the growth again; agent
%     'sensory_delay'  seconds by which an agent feels body late, by touch and joints, by default all bodies; agent
%     'sources'    count of bodies that can play at once (default 4), and seconds of sound that each can hold (default 4)
%     'source_direction'  place and axis (three numbers each, in the frame of body) of the sound that body plays, and its
%                  directivity (0: equal in all directions, 0.5: a cardioid, 1: a figure of eight)
%     'room_temperature'  celsius, of the air and of everything without a temperature of its own
%     'temperature'  celsius, of body and its children
%     'material'   name (mimo_names('material')): the material of body and its children
%     'parameter'  name, value (mimo_parameters)
%     'sense'      path of a shared library with a sense of your own, whose code runs: load only what you trust; agent
%   agent is an agent's number, 1 by default. number is 0 for things without a number.
number = mimo_mex('scene_add', scene, char(what), varargin{:});
end
