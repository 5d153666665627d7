% A world whose infant has hearing, but no vision and no touch.
function world = one_that_hears()
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'hearing', 'ears');
end
