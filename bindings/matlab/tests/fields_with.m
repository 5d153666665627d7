% names = fields_with(name, value, ...): the fields of an infant with these options and without eyes.
function names = fields_with(varargin)
  world = mimo_create('free', 'vision', {}, varargin{:});
  names = {mimo_layout(world).fields.name};
  mimo_close(world);
end
