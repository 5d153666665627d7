function maturity = mimo_maturity(age)
% MIMO_MATURITY  The maturity of eyes and nerves at an age.
%   maturity = mimo_maturity(age), months from 0 to 24, is a struct of the numbers that help mimo_options lists for eyes and
%   nerves. flicker and contrast_threshold are off at all ages, since they are options of their own.
%   The option maturity of mimo_create gives infants the maturity of their age; mimo_scene_add(scene, 'maturity', ...) sets other
%   numbers.
maturity = mimo_mex('maturity', age);
end
