function stage = mimo_stage(varargin)
% MIMO_STAGE  Makes a stage: things of your own, drawn from plain arrays without a simulation.
%   stage = mimo_stage(name, value, ...) has the parts that are given. A value is a struct of arrays, which
%   mimo/experimental/stage.h describes, with a row for each element; how many there are follows from them:
%     'geoms', 'sites'  forms ({'sphere', 'box'}), sizes (n x 3), colors (n x 4), materials, groups, data (a mesh or a field),
%                  object_type
%     'meshes'     vertex_counts, triangle_counts, vertices, triangles, normals, texcoords, ...
%     'fields'     rows, columns, sizes (n x 4), heights: row after row
%     'textures'   types ({'flat'}), heights, widths, channels, srgb,
%                  pixels: row after row, as permute(picture, [3 2 1])(:)
%     'materials'  colors (n x 4), emission, specular, shininess, reflectance, textures, repeats (n x 2), uniform
%     'surfaces'   skins, cloth and ropes: vertex_counts, element_counts, vertices, elements, ...
%     'tendons'    widths, colors, materials, groups
%     'lights'     types ({'sun'}), ambient, diffuse, specular (n x 3), ...
%     'air'        near_plane, far_plane, haze, fog, headlight: help mimo_options
%   stage = mimo_stage(..., 'threads', n) draws on n threads.
%   Materials, meshes, fields, textures and vertices are counted from 1; a material of 0 is none. mimo_stage_update
%   changes parts, mimo_stage_draw draws, mimo_close frees the stage. mimo_messages tells of what cannot be drawn.
stage = mimo_mex('stage', varargin{:});
end
