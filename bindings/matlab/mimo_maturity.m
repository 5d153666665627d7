function maturity = mimo_maturity(age)
% MIMO_MATURITY  How mature eyes and nerves are at an age.
%   maturity = mimo_maturity(age), months from 0 to 24, is a struct of
%     acuity            the finest lines that are seen, cycles per degree; 0: pictures as drawn
%     peak_contrast     the greatest contrast sensitivity
%     chroma            share of colour that is seen, 0 (grey) to 1
%     flicker           Hz: faster changes are seen less and less; 0 (here at all ages, as it is an option): all
%     contrast_threshold  1: contrasts too faint for such eyes are gone; 0 (here at all ages): they stay
%     conduction_speed  of large nerve fibres, m/s; 0: they take no time
%     sensory_delay     from the brain stem to the cortex, s
%     motor_delay       from the cortex to the brain stem, s
%     vision_delay      from the eye to the cortex, s
%     vestibular_delay  from the inner ear to the brain stem, s
%     hearing_delay     from the ear to the cortex, s
%   Infants have it by the option maturity of mimo_create; mimo_scene_add(scene, 'maturity', ...) gives one other numbers.
maturity = mimo_mex('maturity', age);
end
