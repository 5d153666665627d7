% An episode of reaching with random movements. Needs bindings/matlab on the path.
world = mimo_create('reach');
[low, high] = mimo_bounds(world);
observation = mimo_reset(world, 7);
total = 0;
for step = 1:100
  actions = low + (high - low) .* rand(size(low));
  [observation, reward, terminated] = mimo_step(world, actions);
  total = total + reward;
  if terminated, break, end
end
fprintf('%d steps, rewards of %.3f; the fastest joint turns at %.2f rad/s\n', step, total, ...
        max(abs(observation.proprioception_velocity)));
mimo_close(world);
