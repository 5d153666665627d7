% Tests of hearing.
function all_of_them = hearing_tests()
  all_of_them = {@infants_hear_their_own_voice, @infants_hear_played_sounds};
end

% A cry has 82 dB at 1 m, and 99 dB at the infant's own ears: docs/guide/hearing.md. 0 dB are 20 micropascals.
function infants_hear_their_own_voice()
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'hearing', 'ears', 'voice', 1);
  names = {mimo_layout(world).actions.name};
  assert(isequal(names(end-3:end), {'voice:loudness', 'voice:pitch', 'voice:opening', 'voice:front'}));
  cry = [zeros(numel(names) - 4, 1); 1; 0; 1; 1];
  heard = [];
  for step = 1:50
    seen = mimo_step(world, cry);
    if step > 25, heard = [heard; seen.hearing_ear_left(:)]; end
  end
  assert(abs(10 * log10(mean(double(heard) .^ 2) / 4e-10) - 99) < 1);
  mimo_close(world);
end

function infants_hear_played_sounds()
  world = mimo_create('free', 'vision', 0, 'touch', 0, 'hearing', 'ears', 'voice', 1);
  mimo_play(world, 'head', sin(0.3 * (0:799)));
  seen = mimo_step(world, []);
  assert(max(seen.hearing_ear_right(:)) > 0.1);
  refused(@() mimo_play(world, 'head', zeros(1, 10), 44100), 'mimo:INVALID_ARGUMENT');
  mimo_close(world);
end
