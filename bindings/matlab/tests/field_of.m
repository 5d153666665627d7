% field = field_of(layout, name): what a layout says of a field.
function field = field_of(layout, name)
  field = layout.fields(strcmp({layout.fields.name}, name));
end
