% field = field_of(layout, name): a layout's description of a field.
function field = field_of(layout, name)
  field = layout.fields(strcmp({layout.fields.name}, name));
end
