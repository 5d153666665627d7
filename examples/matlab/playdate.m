% A scene of your own: two infants in a room, one of whom holds a toy, in four worlds. Needs bindings/matlab on the path.
scene = mimo_scene();
mimo_scene_add(scene, 'room', 'name', 'playroom');
mimo_scene_add(scene, 'agent', 'name', 'anna', 'vision', {}, 'place', 'soles', 'position', [0 0 0]);
ben = mimo_scene_add(scene, 'agent', 'name', 'ben', 'body', 'fingers', 'face', 'enjoyment', 'vision', {}, ...
                     'place', 'soles', 'position', [1 0 0], 'orientation', [0 0 0 1]);  % he faces her
rattle = ['<mujoco><worldbody><body name="rattle"><geom type="capsule" size=".01 .04" mass=".02"/>' ...
          '<geom type="sphere" size=".02" pos="0 0 .05" mass=".02"/></body></worldbody></mujoco>'];
hand = [0 -0.05 0 1 0 0 0];  % in front of the palm: position and quaternion in the frame of the hand
mimo_scene_add(scene, 'model', 'name', 'toy', 'xml', rattle, 'position', [0.3 0 0.5]);
mimo_scene_add(scene, 'weld', 'body', 'toy/rattle', 'other', 'anna/right_hand', 'pose', hand);
mimo_scene_add(scene, 'skin', 'agent', ben, 'body', 'head', 'spacing', 0.005);
mimo_scene_add(scene, 'limits', 'agent', ben, 'path', 'touch', 'noise', 0.01);

worlds = mimo_create(scene, 'worlds', 4, 'frame_skip', 4);
mimo_close(scene);  % worlds do not need it any more
[low, high] = mimo_bounds(worlds);
mimo_reset(worlds, 7);
for step = 1:25
  actions = low + (high - low) .* mimo_random(worlds, numel(low));
  observation = mimo_step(worlds, actions);
end
mimo_update(worlds);
rattles = mimo_get(worlds, 'body_position', 'toy/rattle');
apart = sqrt(sum((rattles - mimo_get(worlds, 'body_position', 'anna/right_hand')) .^ 2));
fprintf('After %.2f s the rattles are %s m from the hands that hold them; Ben has %d touch sensors\n', max(mimo_time(worlds)), ...
        mat2str(apart, 2), size(observation.ben_touch_force, 1));
mimo_close(worlds);
