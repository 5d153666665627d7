function messages = mimo_messages()
% MIMO_MESSAGES  Messages of the library about scenes and worlds: an infant starts inside of something, contacts are missing, ...
%   messages = mimo_messages() is a struct array of the messages since the last call, the oldest first, at most 256:
%     number  of the worlds or the scene, as mimo_create or mimo_scene returned it. If the call failed, the number that it would
%             have returned
%     level   'warning' or 'info'
%     code    the warning of the physics, which mimo_names(world, 'warning') has at code + 1; otherwise 0
%     text    one line
%     world   the world among several, counted from 1; [] for messages of scenes and of making worlds
%     time    simulated seconds since that world's reset; [] for messages of scenes and of making worlds
messages = mimo_mex('messages');
end
