% An episode of reaching with random movements, and the terms of its reward. Needs bindings/matlab on the path.
world = mimo_create('reach');
[low, high] = mimo_bounds(world);
observation = mimo_reset(world, 7);
terms = mimo_layout(world).terms;
total = zeros(numel(terms), 1);
for step = 1:100
  actions = low + (high - low) .* rand(size(low));
  [observation, reward, terminated, truncated, info] = mimo_step(world, actions);
  total = total + info.terms;
  if terminated, break, end
end
fprintf('%d steps, outcome %d; the fastest joint turns at %.2f rad/s\n', step, info.outcome, ...
        max(abs(observation.proprioception_velocity)));
for i = 1:numel(terms), fprintf('  %s: %.3f in all\n', terms(i).name, total(i)); end
mimo_close(world);
