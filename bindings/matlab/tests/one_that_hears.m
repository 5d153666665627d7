% A world whose infant hears, and neither sees nor feels.
function world = one_that_hears()
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'hearing', 'ears');
end
