% refused_as(action, what): fails unless the action raises an error whose message contains what.
function refused_as(action, what)
  said = message_of(action);
  assert(~isempty(strfind(said, what)), ['"' said '", expected "' what '"']);
end
