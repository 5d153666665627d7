function messages = mimo_messages()
% MIMO_MESSAGES  What the library had to say of scenes and worlds: an infant that starts inside of something, contacts that are
%   missing, ...
%   messages = mimo_messages() is a struct array of what was said since the last call, the oldest first, of at most 256:
%     number  of the worlds or the scene, as mimo_create and mimo_scene gave it; of ones that could not be made the one
%             that they would have had
%     level   'warning' or 'info'
%     code    what it is about, where physics warns: mimo_names(world, 'warning') has it at code + 1; else 0
%     text    one line
%     world   which of many worlds, counted from 1; [] for a scene, or the making of a world
%     time    simulated seconds since that world's reset; [] likewise
messages = mimo_mex('messages');
end
