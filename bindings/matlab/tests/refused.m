% refused(action, identifier): fails unless the action raises that error.
function refused(action, identifier)
  try
    action();
  catch problem
    assert(strcmp(problem.identifier, identifier), [problem.identifier ': ' problem.message]);
    return
  end
  error('was not refused');
end
