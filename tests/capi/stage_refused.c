/* Wrong stages: an array that is missing, too short for the others, or holds a wrong index or no number is refused with
 * its name, and nothing is drawn. Random arrays are refused or drawn, and do no harm.
 */
#include "support/capi.h"

enum { GEOMS = 3, SIDE = 16, PIXELS = SIDE * SIDE };

/* All arrays of one small stage that has some of everything, and its poses. */
typedef struct everything {
  int32_t forms[GEOMS], materials[GEOMS], groups[GEOMS], data[GEOMS];
  double sizes[3 * GEOMS];
  float colors[4 * GEOMS];
  mimo_stage_shapes geoms;

  int32_t vertex_counts[1], normal_counts[1], texcoord_counts[1], triangle_counts[1], triangles[6];
  float vertices[12], normals[12], texcoords[8];
  mimo_stage_meshes meshes;

  int32_t rows[1], columns[1];
  double field_sizes[4];
  float heights[6];
  mimo_stage_fields fields;

  int32_t types[2], widths[2], tex_heights[2], channels[2];
  uint8_t pixels[2 * 2 * 3 + 1 * 6 * 1];
  mimo_stage_textures textures;

  float material_colors[4], emission[1], repeats[2];
  int32_t used[1];
  mimo_stage_materials stuff;

  int32_t surface_vertices[2], surface_elements[2], corners[2], elements[10], surface_materials[2];
  double rest[21];
  float radii[2], surface_colors[8];
  uint8_t sheets[2];
  mimo_stage_surfaces surfaces;

  double widths_of_tendons[1];
  float tendon_colors[4];
  mimo_stage_tendons tendons;

  int32_t light_types[2];
  float diffuse[6], exponent[2];
  mimo_stage_lights lights;
  mimo_stage_air air;
  mimo_stage_config config;

  double positions[3 * GEOMS], rotations[9 * GEOMS], quaternions[4 * GEOMS];
  double light_positions[6], light_directions[6], moved[21], points[9];
  int32_t first[1], counts[1], objects[3];
  int32_t extra_forms[1], extra_materials[1];
  double extra_size[3], extra_position[3], extra_rotation[9];
  float extra_color[4];
  mimo_stage_poses poses;

  double eye[3], look[9];
  mimo_stage_view view;
  uint8_t rgb[3 * PIXELS];
  float depth[PIXELS];
  int32_t segmentation[2 * PIXELS];
} everything;

static everything e;

static void upright(double* matrices, int count) {
  int i;
  for (i = 0; i < 9 * count; ++i) matrices[i] = i % 9 % 4 == 0;
}

static void fill_geoms(void) {
  static const int32_t forms[GEOMS] = {MIMO_FORM_SPHERE, MIMO_FORM_MESH, MIMO_FORM_FIELD};
  int i;
  memcpy(e.forms, forms, sizeof forms);
  for (i = 0; i < 3 * GEOMS; ++i) e.sizes[i] = 0.2;
  for (i = 0; i < 4 * GEOMS; ++i) e.colors[i] = 1;
  e.materials[0] = -1;
  e.geoms.struct_size = sizeof e.geoms;
  e.geoms.count = GEOMS;
  e.geoms.forms = e.forms;
  e.geoms.sizes = e.sizes;
  e.geoms.colors = e.colors;
  e.geoms.materials = e.materials;
  e.geoms.groups = e.groups;
  e.geoms.data = e.data;
}

static void fill_meshes(void) {
  static const float vertices[12] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, texcoords[8] = {0, 0, 1, 0, 1, 1, 0, 1};
  static const int32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  int i;
  memcpy(e.vertices, vertices, sizeof vertices);
  memcpy(e.texcoords, texcoords, sizeof texcoords);
  memcpy(e.triangles, triangles, sizeof triangles);
  for (i = 0; i < 4; ++i) e.normals[3 * i + 2] = 1;
  e.vertex_counts[0] = e.normal_counts[0] = e.texcoord_counts[0] = 4;
  e.triangle_counts[0] = 2;
  e.meshes.struct_size = sizeof e.meshes;
  e.meshes.count = 1;
  e.meshes.vertex_counts = e.vertex_counts;
  e.meshes.normal_counts = e.normal_counts;
  e.meshes.texcoord_counts = e.texcoord_counts;
  e.meshes.triangle_counts = e.triangle_counts;
  e.meshes.vertices = e.vertices;
  e.meshes.normals = e.normals;
  e.meshes.texcoords = e.texcoords;
  e.meshes.triangles = e.triangles;
  e.meshes.vertex_total = e.meshes.normal_total = e.meshes.texcoord_total = 4;
  e.meshes.triangle_total = 2;
}

static void fill_assets(void) {
  static const int32_t types[2] = {MIMO_TEXTURE_FLAT, MIMO_TEXTURE_SKY};
  int i;
  e.rows[0] = 2;
  e.columns[0] = 3;
  for (i = 0; i < 4; ++i) e.field_sizes[i] = 0.5;
  for (i = 0; i < 6; ++i) e.heights[i] = 0.1F * (float)i;
  e.fields.struct_size = sizeof e.fields;
  e.fields.count = 1;
  e.fields.rows = e.rows;
  e.fields.columns = e.columns;
  e.fields.sizes = e.field_sizes;
  e.fields.heights = e.heights;
  e.fields.height_total = 6;
  memcpy(e.types, types, sizeof types);
  e.widths[0] = e.tex_heights[0] = 2;
  e.widths[1] = 1;
  e.tex_heights[1] = 6;
  e.channels[0] = 3;
  e.channels[1] = 1;
  memset(e.pixels, 200, sizeof e.pixels);
  e.textures.struct_size = sizeof e.textures;
  e.textures.count = 2;
  e.textures.types = e.types;
  e.textures.widths = e.widths;
  e.textures.heights = e.tex_heights;
  e.textures.channels = e.channels;
  e.textures.pixels = e.pixels;
  e.textures.pixel_bytes = sizeof e.pixels;
  for (i = 0; i < 4; ++i) e.material_colors[i] = 1;
  e.repeats[0] = e.repeats[1] = 2;
  e.stuff.struct_size = sizeof e.stuff;
  e.stuff.count = 1;
  e.stuff.colors = e.material_colors;
  e.stuff.emission = e.emission;
  e.stuff.repeats = e.repeats;
  e.stuff.textures = e.used;
}

static void fill_what_moves(void) {
  static const int32_t elements[10] = {0, 1, 2, 0, 2, 3, 0, 1, 1, 2};
  int i;
  memcpy(e.elements, elements, sizeof elements);
  e.surface_vertices[0] = 4;
  e.surface_vertices[1] = 3;
  e.surface_elements[0] = e.surface_elements[1] = e.corners[1] = 2;
  e.corners[0] = 3;
  for (i = 0; i < 21; ++i) e.rest[i] = e.moved[i] = 0.1 * ((i * 7) % 11);
  e.radii[0] = e.radii[1] = 0.02F;
  e.sheets[0] = 1;
  for (i = 0; i < 8; ++i) e.surface_colors[i] = 0.8F;
  e.surfaces.struct_size = sizeof e.surfaces;
  e.surfaces.count = 2;
  e.surfaces.vertex_counts = e.surface_vertices;
  e.surfaces.element_counts = e.surface_elements;
  e.surfaces.corners = e.corners;
  e.surfaces.vertices = e.rest;
  e.surfaces.vertex_total = 7;
  e.surfaces.elements = e.elements;
  e.surfaces.element_length = 10;
  e.surfaces.radii = e.radii;
  e.surfaces.sheets = e.sheets;
  e.surfaces.colors = e.surface_colors;
  e.surfaces.materials = e.surface_materials;
  e.widths_of_tendons[0] = 0.01;
  for (i = 0; i < 4; ++i) e.tendon_colors[i] = 0.5F;
  e.tendons.struct_size = sizeof e.tendons;
  e.tendons.count = 1;
  e.tendons.widths = e.widths_of_tendons;
  e.tendons.colors = e.tendon_colors;
}

static void fill_light(void) {
  int i;
  for (i = 0; i < 6; ++i) e.diffuse[i] = 0.4F;
  e.light_types[1] = MIMO_LAMP_SUN;
  e.exponent[0] = 3;
  e.lights.struct_size = sizeof e.lights;
  e.lights.count = 2;
  e.lights.types = e.light_types;
  e.lights.diffuse = e.diffuse;
  e.lights.exponent = e.exponent;
  CHECK_OK(mimo_stage_air_init(&e.air, sizeof e.air));
  e.config.struct_size = sizeof e.config;
  e.config.geoms = &e.geoms;
  e.config.meshes = &e.meshes;
  e.config.fields = &e.fields;
  e.config.textures = &e.textures;
  e.config.materials = &e.stuff;
  e.config.surfaces = &e.surfaces;
  e.config.tendons = &e.tendons;
  e.config.lights = &e.lights;
  e.config.air = &e.air;
}

static void fill_poses(void) {
  int i;
  for (i = 0; i < 3 * GEOMS; ++i) e.positions[i] = 0.3 * (i % 4);
  upright(e.rotations, GEOMS);
  for (i = 0; i < GEOMS; ++i) e.quaternions[4 * i] = 1;
  e.light_positions[2] = e.light_positions[5] = 3;
  e.light_directions[2] = e.light_directions[5] = -1;
  for (i = 0; i < 9; ++i) e.points[i] = 0.2 * i;
  e.counts[0] = 3;
  e.objects[0] = e.objects[1] = e.objects[2] = -1;
  e.extra_forms[0] = MIMO_FORM_BOX;
  e.extra_size[0] = e.extra_size[1] = e.extra_size[2] = 0.1;
  upright(e.extra_rotation, 1);
  for (i = 0; i < 4; ++i) e.extra_color[i] = 0.5F;
  e.poses.struct_size = sizeof e.poses;
  e.poses.geom_count = GEOMS;
  e.poses.geom_positions = e.positions;
  e.poses.geom_rotations = e.rotations;
  e.poses.light_count = 2;
  e.poses.light_positions = e.light_positions;
  e.poses.light_directions = e.light_directions;
  e.poses.vertex_count = 7;
  e.poses.vertices = e.moved;
  e.poses.tendon_count = 1;
  e.poses.tendon_first = e.first;
  e.poses.tendon_points = e.counts;
  e.poses.path_points = e.points;
  e.poses.path_objects = e.objects;
  e.poses.path_count = 3;
  e.poses.extra_count = 1;
  e.poses.extra_forms = e.extra_forms;
  e.poses.extra_sizes = e.extra_size;
  e.poses.extra_positions = e.extra_position;
  e.poses.extra_rotations = e.extra_rotation;
  e.poses.extra_colors = e.extra_color;
  e.poses.extra_materials = e.extra_materials;
  CHECK_OK(mimo_stage_view_init(&e.view, sizeof e.view));
  e.view.width = e.view.height = SIDE;
  e.eye[2] = 4;
  upright(e.look, 1);
  e.view.position = e.eye;
  e.view.rotation = e.look;
  e.view.rgb = e.rgb;
  e.view.rgb_bytes = sizeof e.rgb;
  e.view.depth = e.depth;
  e.view.depth_count = PIXELS;
  e.view.segmentation = e.segmentation;
  e.view.segmentation_count = 2 * PIXELS;
  memset(e.rgb, 0xab, sizeof e.rgb);
}

static void fill_all_arrays(void) {
  memset(&e, 0, sizeof e);
  fill_geoms();
  fill_meshes();
  fill_assets();
  fill_what_moves();
  fill_light();
  fill_poses();
}

static mimo_status create(mimo_stage** stage) {
  *stage = NULL;
  return mimo_stage_create(&e.config, stage);
}

static mimo_status draw(mimo_stage* stage) {
  const mimo_stage_poses* poses = &e.poses;
  const mimo_stage_view* view = &e.view;
  return mimo_stage_draw(stage, &poses, 1, &view, 1);
}

static int picture_is_untouched(void) { return e.rgb[0] == 0xab && memcmp(e.rgb, e.rgb + 1, sizeof e.rgb - 1) == 0; }

/* One thing is made wrong; the call is refused with these words. */
#define REFUSED(change, words)                                   \
  do {                                                           \
    mimo_stage* stage;                                           \
    fill_all_arrays();                                           \
    change;                                                      \
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, words, create(&stage)); \
    CHECK(stage == NULL);                                        \
  } while (0)

static void test_wrong_parts(void) {
  REFUSED(e.geoms.forms = NULL, "geoms: forms is NULL, but count is 3");
  REFUSED(e.geoms.sizes = NULL, "geoms: sizes is NULL");
  REFUSED(e.geoms.colors = NULL, "geoms: colors is NULL");
  REFUSED(e.geoms.count = (size_t)1 << 31, "geoms: count is 2147483648, expected at most");
  REFUSED(e.geoms.count = SIZE_MAX, "geoms: count is");
  REFUSED(e.sizes[4] = NAN, "geoms: sizes[1, 1] is nan, expected metres");
  REFUSED(e.sizes[0] = -1, "geoms: sizes[0, 0] is -1");
  REFUSED(e.colors[7] = INFINITY, "geoms: colors[1, 3] is inf");
  REFUSED(e.materials[2] = 1, "geoms: materials[2] is 1, expected -1, or a material 0 to 0");
  REFUSED(e.materials[2] = -2, "geoms: materials[2] is -2");
  REFUSED(e.data[1] = 1, "geoms: data[1] is 1, expected a mesh 0 to 0");
  REFUSED(e.data[2] = -1, "geoms: data[2] is -1, expected a height field 0 to 0");
  REFUSED(e.geoms.data = NULL, "geoms: data[1] is -1, expected a mesh");
  REFUSED(e.config.meshes = NULL, "geoms: data[1] is 0, expected a mesh, of which there is none");
  REFUSED(e.used[0] = 2, "materials: textures[0] is 2, expected -1, or a texture 0 to 1");
  REFUSED(e.emission[0] = -1, "materials: emission[0] is -1");
  REFUSED(e.repeats[1] = NAN, "materials: repeats[0, 1] is nan");
  REFUSED(e.stuff.colors = NULL, "materials: colors is NULL");
  REFUSED(e.light_types[0] = 0; e.diffuse[4] = NAN, "lights: diffuse[1, 1] is nan");
  REFUSED(e.lights.types = NULL, "lights: types is NULL");
  REFUSED(e.widths_of_tendons[0] = INFINITY, "tendons: widths[0] is inf");
  REFUSED(e.air.far_plane = 0.001, "air: far_plane is 0.001, expected more than 0.01");
  REFUSED(e.air.diffuse[2] = NAN, "air: diffuse[0, 2] is nan");
}

static void test_wrong_assets(void) {
  REFUSED(e.meshes.vertex_counts = NULL, "meshes: vertex_counts is NULL");
  REFUSED(e.meshes.vertices = NULL, "meshes: vertices is NULL");
  REFUSED(e.vertex_counts[0] = -1, "meshes: vertex_counts[0] is -1");
  REFUSED(e.meshes.vertex_total = 5, "meshes: vertex_total is 5, expected 4, the sum of vertex_counts");
  REFUSED(e.meshes.triangle_total = 1, "meshes: triangle_total is 1, expected 2");
  REFUSED(e.meshes.normals = NULL, "meshes: normals is NULL, but normal_total is 4");
  REFUSED(e.triangles[5] = 4, "meshes: triangles[1, 2] is 4, but mesh 0 has 4 vertices");
  REFUSED(e.triangles[0] = -1, "meshes: triangles[0, 0] is -1");
  REFUSED(e.triangles[0] = INT32_MAX, "meshes: triangles[0, 0] is 2147483647");
  REFUSED(e.texcoord_counts[0] = 3;
          e.meshes.texcoord_total = 3, "meshes: texcoord_triangles[1, 2] is 3, but mesh 0 has 3");
  REFUSED(e.vertices[3] = NAN, "meshes: vertices[1, 0] is nan");
  REFUSED(e.rows[0] = 1, "fields: rows[0] is 1, expected 2 to 65536");
  REFUSED(e.columns[0] = INT32_MAX, "fields: columns[0] is 2147483647");
  REFUSED(e.fields.height_total = 5, "fields: height_total is 5, expected 6");
  REFUSED(e.heights[2] = NAN, "fields: heights[2] is nan");
  REFUSED(e.field_sizes[3] = -1, "fields: sizes[0, 3] is -1");
  REFUSED(e.types[0] = 3, "textures: types[0] is 3");
  REFUSED(e.widths[0] = 0, "textures: widths[0] is 0, expected 1 to 65536 pixels");
  REFUSED(e.widths[0] = INT32_MAX, "textures: widths[0] is 2147483647");
  REFUSED(e.tex_heights[1] = 5, "textures: heights[1] is 5, expected 1 or 6 of a cube 1 pixels wide");
  REFUSED(e.channels[0] = 5, "textures: channels[0] is 5");
  REFUSED(e.textures.pixel_bytes = 17, "textures: pixel_bytes is 17, expected 18");
  REFUSED(e.textures.pixels = NULL, "textures: pixels is NULL");
  REFUSED(e.surfaces.elements = NULL, "surfaces: elements is NULL");
  REFUSED(e.elements[9] = 3, "surfaces: elements[9] is 3, but surface 1 has 3 vertices");
  REFUSED(e.elements[0] = -1, "surfaces: elements[0] is -1");
  REFUSED(e.corners[0] = 4, "surfaces: corners[0] is 4, expected 2 or 3");
  REFUSED(e.surfaces.element_length = 9, "surfaces: element_length is 9, expected 10");
  REFUSED(e.surfaces.vertex_total = 6, "surfaces: vertex_total is 6, expected 7");
  REFUSED(e.rest[20] = NAN, "surfaces: vertices[6, 2] is nan");
  REFUSED(e.radii[1] = -1, "surfaces: radii[1] is -1");
  REFUSED(e.surface_materials[1] = 3, "surfaces: materials[1] is 3");
}

#define UNDRAWN(change, words)                                \
  do {                                                        \
    fill_all_arrays();                                        \
    change;                                                   \
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, words, draw(stage)); \
    CHECK(picture_is_untouched());                            \
  } while (0)

static void test_wrong_poses(void) {
  mimo_stage* stage;
  fill_all_arrays();
  CHECK_OK(create(&stage));
  CHECK_OK(draw(stage));
  CHECK(!picture_is_untouched());
  UNDRAWN(e.poses.geom_count = 2, "poses[0]: geom_count is 2, expected 3, or 0");
  UNDRAWN(e.poses.geom_positions = NULL, "poses[0]: geom_positions is NULL");
  UNDRAWN(e.poses.geom_rotations = NULL, "geom_rotations and geom_quaternions are NULL, expected one of them");
  UNDRAWN(e.poses.geom_quaternions = e.quaternions, "are both given, expected one of them");
  UNDRAWN(e.positions[4] = NAN, "poses[0]: geom_positions[1, 1] is nan, expected a finite number");
  UNDRAWN(e.rotations[8] = INFINITY, "poses[0]: geom_rotations[0, 8] is inf");
  UNDRAWN(e.poses.geom_rotations = NULL; e.poses.geom_quaternions = e.quaternions;
          e.quaternions[4] = 0, "poses[0]: geom_quaternions[1] has a length of 0, expected 1");
  UNDRAWN(e.poses.site_count = 1, "poses[0]: site_count is 1, expected 0");
  UNDRAWN(e.light_directions[1] = NAN, "poses[0]: light_directions[0, 1] is nan");
  UNDRAWN(e.poses.light_count = 3, "poses[0]: light_count is 3");
  UNDRAWN(e.poses.vertex_count = 8, "poses[0]: vertex_count is 8, expected 7");
  UNDRAWN(e.moved[0] = -INFINITY, "poses[0]: vertices[0, 0] is -inf");
  UNDRAWN(e.poses.tendon_first = NULL, "poses[0]: tendon_first is NULL");
  UNDRAWN(e.counts[0] = 4, "poses[0]: tendon_points[0] is 4, expected 0 to 3");
  UNDRAWN(e.first[0] = 1, "poses[0]: tendon_first[0] is 1, but it has 3 of 3 points");
  UNDRAWN(e.first[0] = -1, "poses[0]: tendon_first[0] is -1");
  UNDRAWN(e.points[8] = NAN, "path_points[2, 2] is nan");
  UNDRAWN(e.extra_forms[0] = MIMO_FORM_MESH, "poses[0]: extra_forms[0] is 7");
  UNDRAWN(e.extra_materials[0] = 1, "poses[0]: extra_materials[0] is 1, expected -1 to 0");
  UNDRAWN(e.extra_size[1] = -1, "extra_sizes[0, 1] is -1");
  UNDRAWN(e.poses.extra_count = (size_t)1 << 31, "poses[0]: extra_count is 2147483648");
  UNDRAWN(e.view.position = NULL, "views[0]: position is NULL, expected 3 numbers");
  UNDRAWN(e.look[4] = NAN, "views[0]: rotation[4] is nan");
  UNDRAWN(e.view.rgb_stride = 3 * SIDE - 1, "views[0]: rgb_stride is 47, expected at least 48, a row");
  UNDRAWN(e.view.depth_stride = SIZE_MAX, "views[0]: depth_stride is");
  UNDRAWN(e.view.depth = NULL, "views[0]: depth is NULL, but its length is 256");
  fill_all_arrays();
  e.view.rgb_stride = 3 * SIDE + 1; /* one pixel more in each row but the last */
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "views[0]: rgb has a length of 768, but 783 are needed", draw(stage));
  CHECK(picture_is_untouched());
  mimo_stage_destroy(stage);
}

/* ---- At random ---- */

static uint64_t state = 1;

static uint32_t draw_lot(uint32_t count) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % count;
}

static double any_number(void) {
  static const double numbers[] = {0,   -1,   1,   1e-300, 1e300,    1e12,      -1e12,
                                   1e6, 1e-9, 0.5, NAN,    INFINITY, -INFINITY, 3e38};
  return numbers[draw_lot(sizeof numbers / sizeof *numbers)];
}

static int32_t any_whole(void) {
  static const int32_t numbers[] = {0, -1, 1, 2, 3, 6, 7, 8, 9, 100, 65536, INT32_MAX, INT32_MIN, -7};
  return numbers[draw_lot(sizeof numbers / sizeof *numbers)];
}

#define NUMBERS(array) \
  { array, sizeof(array) / sizeof *(array), sizeof *(array), 1 }
#define WHOLES(array) \
  { array, sizeof(array) / sizeof *(array), sizeof *(array), 0 }

static void spoil_some_arrays(void) {
  const struct {
    void* array;
    size_t count, size;
    int real;
  } all[] = {WHOLES(e.forms),
             WHOLES(e.materials),
             WHOLES(e.groups),
             WHOLES(e.data),
             NUMBERS(e.sizes),
             NUMBERS(e.colors),
             WHOLES(e.vertex_counts),
             WHOLES(e.normal_counts),
             WHOLES(e.texcoord_counts),
             WHOLES(e.triangle_counts),
             WHOLES(e.triangles),
             NUMBERS(e.vertices),
             NUMBERS(e.normals),
             NUMBERS(e.texcoords),
             WHOLES(e.rows),
             WHOLES(e.columns),
             NUMBERS(e.field_sizes),
             NUMBERS(e.heights),
             WHOLES(e.types),
             WHOLES(e.widths),
             WHOLES(e.tex_heights),
             WHOLES(e.channels),
             NUMBERS(e.material_colors),
             NUMBERS(e.emission),
             NUMBERS(e.repeats),
             WHOLES(e.used),
             WHOLES(e.surface_vertices),
             WHOLES(e.surface_elements),
             WHOLES(e.corners),
             WHOLES(e.elements),
             WHOLES(e.surface_materials),
             NUMBERS(e.rest),
             NUMBERS(e.radii),
             NUMBERS(e.surface_colors),
             NUMBERS(e.widths_of_tendons),
             WHOLES(e.light_types),
             NUMBERS(e.diffuse),
             NUMBERS(e.exponent),
             NUMBERS(e.positions),
             NUMBERS(e.rotations),
             NUMBERS(e.light_positions),
             NUMBERS(e.light_directions),
             NUMBERS(e.moved),
             NUMBERS(e.points),
             WHOLES(e.first),
             WHOLES(e.counts),
             WHOLES(e.objects),
             WHOLES(e.extra_forms),
             WHOLES(e.extra_materials),
             NUMBERS(e.extra_size),
             NUMBERS(e.extra_position),
             NUMBERS(e.extra_rotation),
             NUMBERS(e.extra_color),
             NUMBERS(e.eye),
             NUMBERS(e.look)};
  const size_t which = draw_lot(sizeof all / sizeof *all), at = draw_lot((uint32_t)all[which].count);
  unsigned char* to = (unsigned char*)all[which].array + at * all[which].size;
  const double real = any_number();
  const float narrow = (float)(fabs(real) < 3e38 || !isfinite(real) ? real : 0);
  const int32_t whole = any_whole();
  if (!all[which].real)
    memcpy(to, &whole, sizeof whole);
  else if (all[which].size == sizeof narrow)
    memcpy(to, &narrow, sizeof narrow);
  else
    memcpy(to, &real, sizeof real);
}

static void test_random_arrays(void) {
  int round, k, made = 0, refused = 0, drawn = 0;
  for (round = 0; round < 4000; ++round) {
    mimo_stage* stage;
    fill_all_arrays();
    for (k = (int)draw_lot(3); k >= 0; --k) spoil_some_arrays();
    if (create(&stage) != MIMO_OK) {
      ++refused;
      CHECK(stage == NULL && mimo_last_error()[0] != '\0');
      continue;
    }
    ++made;
    if (draw(stage) == MIMO_OK)
      ++drawn;
    else
      CHECK(picture_is_untouched());
    mimo_stage_destroy(stage);
  }
  CHECK(refused > 400 && made > 400 && drawn > 200 && drawn < made);
}

int main(void) {
  test_wrong_parts();
  test_wrong_assets();
  test_wrong_poses();
  test_random_arrays();
  return failures();
}
