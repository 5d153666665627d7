% said = message_of(action): the message of the error that it raises, "" if it raises none.
function said = message_of(action)
  said = '';
  try
    action();
  catch problem
    said = regexprep(problem.message, '^mimo_mex: ', '');  % so begin Octave's
  end
end
