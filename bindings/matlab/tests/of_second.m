% its = of_second(values): the values of the second of two worlds, for any size.
function its = of_second(values)
  index = [repmat({':'}, 1, ndims(values) - 1), {2}];
  its = values(index{:});
end
