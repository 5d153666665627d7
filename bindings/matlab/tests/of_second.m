% its = of_second(values): what the second of two worlds has, whatever the size.
function its = of_second(values)
  index = [repmat({':'}, 1, ndims(values) - 1), {2}];
  its = values(index{:});
end
