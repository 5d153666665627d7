function text = mimo_scene_xml(scene)
% MIMO_SCENE_XML  A scene as one MJCF document, as MuJoCo will compile it.
%   text = mimo_scene_xml(scene) is for looking at it and for other tools.
text = mimo_mex('scene_xml', scene);
end
