/* Pictures of plain arrays, compared with what geometry says: where outlines lie, how far things are, how light falls.
 */
#include "support/capi.h"

enum { SIZE = 201, PIXELS = SIZE * SIZE, MIDDLE = PIXELS / 2 };

static const double upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const double above[3] = {0, 0, 5}; /* looks down along -z: right is x, up is y */
static const double origin[3] = {0, 0, 0};

static uint8_t rgb[3 * PIXELS], other[3 * PIXELS];
static float depth[PIXELS];
static int32_t objects[2 * PIXELS];

/* f pixels are one metre at a distance of one metre. */
static double focal(void) { return 0.5 * SIZE / tan(10 * acos(-1.0) / 180); }

static mimo_stage_config empty_stage(void) {
  mimo_stage_config config;
  memset(&config, 0, sizeof config);
  config.struct_size = sizeof config;
  return config;
}

static mimo_stage_view from(const double* position) {
  mimo_stage_view view;
  CHECK_OK(mimo_stage_view_init(&view, sizeof view));
  view.width = view.height = SIZE;
  view.fovy = 20;
  view.position = position;
  view.rotation = upright;
  view.rgb = rgb;
  view.rgb_bytes = sizeof rgb;
  view.depth = depth;
  view.depth_count = PIXELS;
  view.segmentation = objects;
  view.segmentation_count = 2 * PIXELS;
  return view;
}

static mimo_stage_poses no_poses(void) {
  mimo_stage_poses poses;
  memset(&poses, 0, sizeof poses);
  poses.struct_size = sizeof poses;
  return poses;
}

static mimo_stage_poses one_geom(void) {
  mimo_stage_poses poses = no_poses();
  poses.geom_count = 1;
  poses.geom_positions = origin;
  poses.geom_rotations = upright;
  return poses;
}

static void draw(mimo_stage* stage, const mimo_stage_poses* poses, const mimo_stage_view* view) {
  CHECK_OK(mimo_stage_draw(stage, &poses, 1, &view, 1));
}

static size_t pixels_of(int32_t id, int32_t type) {
  size_t i, count = 0;
  for (i = 0; i < PIXELS; ++i) count += objects[2 * i] == id && objects[2 * i + 1] == type;
  return count;
}

/* ---- Shapes ---- */

static const float white[4] = {1, 1, 1, 1};

static mimo_stage_shapes one_shape(const int32_t* form, const double* size) {
  mimo_stage_shapes shapes;
  memset(&shapes, 0, sizeof shapes);
  shapes.struct_size = sizeof shapes;
  shapes.object_type = 5;
  shapes.count = 1;
  shapes.forms = form;
  shapes.sizes = size;
  shapes.colors = white;
  return shapes;
}

static mimo_stage* stage_of(const mimo_stage_shapes* geoms) {
  mimo_stage_config config = empty_stage();
  mimo_stage* stage = NULL;
  config.geoms = geoms;
  CHECK_OK(mimo_stage_create(&config, &stage));
  return stage;
}

/* A sphere of radius .5, 5 m away: its outline is a circle with a slope of r / sqrt(d^2 - r^2), and a ray of slope s
 * meets it where (1 + s^2) t^2 - 2 d t + d^2 - r^2 = 0. */
static void test_sphere(void) {
  const int32_t form = MIMO_FORM_SPHERE;
  const double size[3] = {0.5, 0, 0}, pi = acos(-1.0);
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  const mimo_stage_view view = from(above);
  mimo_stage* stage = stage_of(&geoms);
  const double radius = focal() * 0.5 / sqrt(25 - 0.25);
  int column;
  draw(stage, &poses, &view);
  CHECK_NEAR(pi * radius * radius, (double)pixels_of(0, 5), 2 * pi * radius * 0.1);
  CHECK(pixels_of(0, 5) + pixels_of(-1, -1) == PIXELS);
  for (column = -56; column <= 56; column += 8) {
    const double s = column / focal(), a = 1 + s * s;
    CHECK_NEAR((5 - sqrt(25 - a * (25 - 0.25))) / a, depth[MIDDLE + column], 1e-4);
  }
  CHECK(depth[0] == 50.0F); /* nothing: the far plane */
  /* The headlight, straight on: .1 ambient, .4 diffuse, .5 of highlights on a material with .5. */
  CHECK_NEAR(255 * (0.1 + 0.4 + 0.25), rgb[3 * MIDDLE], 2);
  CHECK(rgb[0] == 0);
  mimo_stage_destroy(stage);
}

/* The upper side of a box of half side .5 is 4.5 m away: a square of f / 4.5 pixels. */
static void test_box(void) {
  const int32_t form = MIMO_FORM_BOX;
  const double size[3] = {0.5, 0.5, 0.5};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  const mimo_stage_view view = from(above);
  mimo_stage* stage = stage_of(&geoms);
  const double side = focal() / 4.5;
  draw(stage, &poses, &view);
  CHECK_NEAR(side * side, (double)pixels_of(0, 5), 2 * side);
  CHECK_NEAR(4.5, depth[MIDDLE], 1e-5);
  CHECK_NEAR(4.5, depth[MIDDLE + 60], 1e-5); /* the side is 127 pixels long */
  CHECK(objects[2 * (MIDDLE + 66)] == -1);
  mimo_stage_destroy(stage);
}

/* Turned by 90 degrees about y, a cylinder along z lies along x: by a matrix and by a quaternion. */
static void test_rotations(void) {
  const int32_t form = MIMO_FORM_CYLINDER;
  const double size[3] = {0.1, 0.6, 0}, matrix[9] = {0, 0, 1, 0, 1, 0, -1, 0, 0};
  const double quaternion[4] = {sqrt(0.5), 0, sqrt(0.5), 0};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_view view = from(above);
  mimo_stage_poses poses = one_geom();
  mimo_stage* stage = stage_of(&geoms);
  poses.geom_rotations = matrix;
  draw(stage, &poses, &view);
  CHECK_NEAR(4.9, depth[MIDDLE], 1e-5);
  CHECK_NEAR(4.9, depth[MIDDLE + 60], 1e-5);
  CHECK(objects[2 * (MIDDLE + 60 * SIZE)] == -1);
  memcpy(other, rgb, sizeof rgb);
  poses.geom_rotations = NULL;
  poses.geom_quaternions = quaternion;
  draw(stage, &poses, &view);
  CHECK_NEAR(4.9, depth[MIDDLE + 60], 1e-5);
  CHECK(memcmp(other + 3 * MIDDLE, rgb + 3 * MIDDLE, 3) == 0);
  mimo_stage_destroy(stage);
}

/* Groups: 3 is not shown by default; less than 0 is 0. */
static void test_groups(void) {
  const int32_t forms[2] = {MIMO_FORM_SPHERE, MIMO_FORM_SPHERE}, groups[2] = {3, -4};
  const double sizes[6] = {0.2, 0, 0, 0.1, 0, 0}, places[6] = {0, 0, 0, 0.3, 0, 0};
  const double turns[18] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const float colors[8] = {1, 0, 0, 1, 0, 1, 0, 1};
  mimo_stage_shapes geoms = one_shape(forms, sizes);
  mimo_stage_view view = from(above);
  mimo_stage_poses poses = one_geom();
  mimo_stage* stage;
  geoms.count = 2;
  geoms.groups = groups;
  geoms.colors = colors;
  poses.geom_count = 2;
  poses.geom_positions = places;
  poses.geom_rotations = turns;
  stage = stage_of(&geoms);
  draw(stage, &poses, &view);
  CHECK(pixels_of(0, 5) == 0 && pixels_of(1, 5) > 0);
  view.geom_groups = 1u << 3;
  draw(stage, &poses, &view);
  CHECK(pixels_of(0, 5) > 0 && pixels_of(1, 5) == 0);
  poses.geom_count = 0; /* no geoms at all */
  draw(stage, &poses, &view);
  CHECK(pixels_of(-1, -1) == PIXELS);
  mimo_stage_destroy(stage);
}

/* ---- Light and textures ---- */

static mimo_stage_lights one_light(const int32_t* type, const float* ambient, const float* diffuse) {
  static const uint8_t no = 0;
  static const float dark[3] = {0, 0, 0};
  mimo_stage_lights lights;
  memset(&lights, 0, sizeof lights);
  lights.struct_size = sizeof lights;
  lights.count = 1;
  lights.types = type;
  lights.casts_shadow = &no;
  lights.ambient = ambient;
  lights.diffuse = diffuse;
  lights.specular = dark;
  return lights;
}

/* Lambert's law: a white plane under a sun 60 degrees from its normal, without highlights, is ambient + diffuse cos 60.
 */
static void test_lambert(void) {
  const int32_t form = MIMO_FORM_PLANE, sun = MIMO_LAMP_SUN;
  const double size[3] = {0, 0, 0}, direction[3] = {sqrt(0.75), 0, -0.5};
  const float ambient[3] = {0.1F, 0.1F, 0.1F}, diffuse[3] = {0.8F, 0.4F, 0.2F};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_lights lights = one_light(&sun, ambient, diffuse);
  const mimo_stage_view view = from(above);
  mimo_stage_config config = empty_stage();
  mimo_stage_poses poses = one_geom();
  mimo_stage_air air;
  mimo_stage* stage = NULL;
  int k;
  CHECK_OK(mimo_stage_air_init(&air, sizeof air));
  CHECK(air.near_plane == 0.01 && air.far_plane == 50 && air.headlight == 1);
  air.headlight = 0;
  config.geoms = &geoms;
  config.lights = &lights;
  config.air = &air;
  CHECK_OK(mimo_stage_create(&config, &stage));
  poses.light_count = 1;
  poses.light_positions = above;
  poses.light_directions = direction;
  draw(stage, &poses, &view);
  for (k = 0; k < 3; ++k) CHECK_NEAR(255 * (0.1 + 0.5 * diffuse[k]), rgb[3 * MIDDLE + k], 1);
  CHECK_NEAR(5, depth[MIDDLE + 90], 1e-4);
  mimo_stage_destroy(stage);
}

/* A square of two triangles, with a texture of 2 x 2 texels: red and green above, blue and white below. */
static void test_mesh(void) {
  static const float vertices[12] = {-0.5F, -0.5F, 0, 0.5F, -0.5F, 0, 0.5F, 0.5F, 0, -0.5F, 0.5F, 0};
  static const float texcoords[8] = {0, 1, 1, 1, 1, 0, 0, 0}; /* (0, 0) is the first row's start: upper left */
  static const int32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  static const uint8_t pixels[12] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  const int32_t form = MIMO_FORM_MESH, zero = 0, two = 2, four = 4, flat = MIMO_TEXTURE_FLAT, sun = MIMO_LAMP_SUN;
  const double size[3] = {0, 0, 0}, down[3] = {0, 0, -1};
  const float full[3] = {1, 1, 1}, dark[3] = {0, 0, 0}, none = 0;
  const int quarter = 28, corners[4] = {-1 - SIZE, 1 - SIZE, -1 + SIZE, 1 + SIZE}; /* the side is 114 pixels long */
  mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_lights lights = one_light(&sun, full, dark);
  const mimo_stage_view view = from(above);
  mimo_stage_config config = empty_stage();
  mimo_stage_poses poses = one_geom();
  mimo_stage_meshes meshes;
  mimo_stage_textures textures;
  mimo_stage_materials materials;
  mimo_stage_air air;
  mimo_stage* stage = NULL;
  int i, k;
  memset(&meshes, 0, sizeof meshes);
  meshes.struct_size = sizeof meshes;
  meshes.count = 1;
  meshes.vertex_counts = meshes.texcoord_counts = &four;
  meshes.triangle_counts = &two;
  meshes.vertices = vertices;
  meshes.vertex_total = meshes.texcoord_total = 4;
  meshes.texcoords = texcoords;
  meshes.triangles = triangles;
  meshes.triangle_total = 2;
  memset(&textures, 0, sizeof textures);
  textures.struct_size = sizeof textures;
  textures.count = 1;
  textures.types = &flat;
  textures.widths = textures.heights = &two;
  textures.pixels = pixels;
  textures.pixel_bytes = sizeof pixels;
  memset(&materials, 0, sizeof materials);
  materials.struct_size = sizeof materials;
  materials.count = 1;
  materials.colors = white;
  materials.textures = &zero;
  materials.specular = &none;
  geoms.data = geoms.materials = &zero;
  CHECK_OK(mimo_stage_air_init(&air, sizeof air));
  air.headlight = 0;
  config.geoms = &geoms;
  config.meshes = &meshes;
  config.textures = &textures;
  config.materials = &materials;
  config.lights = &lights;
  config.air = &air;
  CHECK_OK(mimo_stage_create(&config, &stage));
  poses.light_count = 1;
  poses.light_positions = above;
  poses.light_directions = down;
  draw(stage, &poses, &view);
  for (i = 0; i < 4; ++i) {
    const uint8_t* seen = rgb + 3 * (MIDDLE + quarter * corners[i]);
    /* The middles of texels are 28.5 pixels away; half a pixel is 1 / 114 of the next texel, along each axis. */
    for (k = 0; k < 3; ++k) CHECK_NEAR(pixels[3 * i + k], seen[k], 2 * 255 / 114.0 + 0.5);
  }
  CHECK_NEAR(focal() / 5 * focal() / 5, (double)pixels_of(0, 5), 2 * focal() / 5);
  mimo_stage_destroy(stage);
}

/* White light on textures of one texel: coded by sRGB, 188 is (((188 / 255 + .055) / 1.055) ^ 2.4) 255 = 128.2, and 10
 * is 10 / 12.92 = .8 (IEC 61966-2-1). Of two textures, one is. */
static void test_srgb(void) {
  static const uint8_t pixels[6] = {188, 10, 255, 188, 10, 255}, coded[2] = {0, 1};
  static const uint8_t expected[2][3] = {{188, 10, 255}, {128, 1, 255}};
  const int32_t form = MIMO_FORM_PLANE, zero = 0, ones[2] = {1, 1}, flat[2] = {MIMO_TEXTURE_FLAT, MIMO_TEXTURE_FLAT};
  const double size[3] = {0, 0, 0};
  const float full[3] = {1, 1, 1}, dark[3] = {0, 0, 0};
  const mimo_stage_view view = from(above);
  const mimo_stage_poses poses = one_geom();
  mimo_stage_shapes geoms = one_shape(&form, size);
  mimo_stage_config config = empty_stage();
  mimo_stage_textures textures;
  mimo_stage_materials materials;
  mimo_stage_air air;
  int32_t which;
  int k;
  memset(&textures, 0, sizeof textures);
  textures.struct_size = sizeof textures;
  textures.count = 2;
  textures.types = flat;
  textures.widths = textures.heights = ones;
  textures.pixels = pixels;
  textures.pixel_bytes = sizeof pixels;
  textures.srgb = coded;
  memset(&materials, 0, sizeof materials);
  materials.struct_size = sizeof materials;
  materials.count = 1;
  materials.colors = white;
  materials.textures = &which;
  geoms.materials = &zero;
  CHECK_OK(mimo_stage_air_init(&air, sizeof air));
  memcpy(air.ambient, full, sizeof full);
  memcpy(air.diffuse, dark, sizeof dark);
  memcpy(air.specular, dark, sizeof dark);
  config.geoms = &geoms;
  config.textures = &textures;
  config.materials = &materials;
  config.air = &air;
  for (which = 0; which < 2; ++which) {
    mimo_stage* stage = NULL;
    CHECK_OK(mimo_stage_create(&config, &stage));
    draw(stage, &poses, &view);
    for (k = 0; k < 3; ++k) CHECK(rgb[3 * MIDDLE + k] == expected[which][k]);
    mimo_stage_destroy(stage);
  }
}

/* Heights of 1 in a field 2 m long, 1 m wide and .3 m high. */
static void test_field(void) {
  const int32_t form = MIMO_FORM_FIELD, zero = 0, two = 2, three = 3;
  const double size[3] = {0, 0, 0}, sizes[4] = {1, 0.5, 0.3, 0.1};
  const float heights[6] = {1, 1, 1, 1, 1, 1};
  mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  const mimo_stage_view view = from(above);
  mimo_stage_config config = empty_stage();
  mimo_stage_fields fields;
  mimo_stage* stage = NULL;
  memset(&fields, 0, sizeof fields);
  fields.struct_size = sizeof fields;
  fields.count = 1;
  fields.rows = &two;
  fields.columns = &three;
  fields.sizes = sizes;
  fields.heights = heights;
  fields.height_total = 6;
  geoms.data = &zero;
  config.geoms = &geoms;
  config.fields = &fields;
  CHECK_OK(mimo_stage_create(&config, &stage));
  draw(stage, &poses, &view);
  CHECK_NEAR(4.7, depth[MIDDLE], 1e-5);
  CHECK_NEAR(4.7, depth[MIDDLE + 95], 1e-5); /* .78 m along x; across, it ends after 60 pixels */
  CHECK(objects[2 * (MIDDLE + 63 * SIZE)] == -1);
  mimo_stage_destroy(stage);
}

/* ---- What moves ---- */

/* A sheet of two triangles, .1 m thick on both sides, is seen from above and from below; a rope is rods. */
static void test_surfaces(void) {
  static const double vertices[21] = {-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5,
                                      0,    0,    0, 0,   0,    0, 0,   0,   0, 0};
  static const double moved[21] = {-0.5, -0.5, 1,   0.5, -0.5, 1,   0.5, 0.5, 1,   -0.5, 0.5,
                                   1,    -0.8, 0.7, 0,   0,    0.7, 0,   0.8, 0.7, 0};
  static const int32_t elements[10] = {0, 1, 2, 0, 2, 3, 0, 1, 1, 2};
  static const int32_t vertex_counts[2] = {4, 3}, element_counts[2] = {2, 2}, corners[2] = {3, 2},
                       names[4] = {7, 9, 8, 9};
  static const float radii[2] = {0.1F, 0.05F}, colors[8] = {1, 1, 1, 1, 0, 1, 0, 1};
  static const uint8_t sheets[2] = {1, 0};
  static const double below[3] = {0, 0, -5}, upward[9] = {1, 0, 0, 0, -1, 0, 0, 0, -1};
  const double s = 80 / focal(), b = 0.7 * s + 5;
  mimo_stage_config config = empty_stage();
  mimo_stage_view view = from(above);
  mimo_stage_poses poses = no_poses();
  mimo_stage_surfaces surfaces;
  mimo_stage* stage = NULL;
  memset(&surfaces, 0, sizeof surfaces);
  surfaces.struct_size = sizeof surfaces;
  surfaces.count = 2;
  surfaces.vertex_counts = vertex_counts;
  surfaces.element_counts = element_counts;
  surfaces.corners = corners;
  surfaces.vertices = vertices;
  surfaces.vertex_total = 7;
  surfaces.elements = elements;
  surfaces.element_length = 10;
  surfaces.radii = radii;
  surfaces.sheets = sheets;
  surfaces.colors = colors;
  surfaces.objects = names;
  config.surfaces = &surfaces;
  CHECK_OK(mimo_stage_create(&config, &stage));
  poses.vertex_count = 7;
  poses.vertices = moved;
  draw(stage, &poses, &view);
  CHECK_NEAR(3.9, depth[MIDDLE], 1e-5); /* the sheet lies 1 m high and is .1 m thick */
  CHECK(objects[2 * MIDDLE] == 7 && objects[2 * MIDDLE + 1] == 9);
  /* The rope, .7 m along y, 80 pixels up: where a ray of that slope meets a circle of its radius. */
  CHECK_NEAR((b - sqrt(b * b - (1 + s * s) * (0.49 + 25 - 0.0025))) / (1 + s * s), depth[MIDDLE - 80 * SIZE], 1e-4);
  CHECK(objects[2 * (MIDDLE - 80 * SIZE)] == 8);
  view.position = below;
  view.rotation = upward;
  draw(stage, &poses, &view);
  CHECK_NEAR(5.9, depth[MIDDLE], 1e-5);
  view.surface_groups = 0;
  draw(stage, &poses, &view);
  CHECK(pixels_of(-1, -1) == PIXELS);
  mimo_stage_destroy(stage);
}

/* Tendons: two paths, one of which is interrupted by a pulley; and a marker for one picture. */
static void test_tendons_and_extras(void) {
  static const double widths[2] = {0.05, 0.02},
                      points[15] = {-0.5, 0, 0, 0.5, 0, 0, -0.5, 0.5, 0, 0, 0.5, 0, 0.5, 0.5, 0};
  static const int32_t first[2] = {0, 2}, counts[2] = {2, 3}, kinds[5] = {-1, -1, -1, -1, -2};
  static const float colors[8] = {1, 0, 0, 1, 0, 0, 1, 1};
  static const int32_t cube = MIMO_FORM_BOX, name[2] = {3, 4};
  static const double size[3] = {0.05, 0.05, 0.05}, place[3] = {0, -0.5, 0};
  mimo_stage_config config = empty_stage();
  mimo_stage_poses poses = no_poses();
  const mimo_stage_view view = from(above);
  mimo_stage_tendons tendons;
  mimo_stage* stage = NULL;
  const int half_metre = 57; /* f / 5 / 2 */
  memset(&tendons, 0, sizeof tendons);
  tendons.struct_size = sizeof tendons;
  tendons.object_type = 18;
  tendons.count = 2;
  tendons.widths = widths;
  tendons.colors = colors;
  config.tendons = &tendons;
  CHECK_OK(mimo_stage_create(&config, &stage));
  poses.tendon_count = 2;
  poses.tendon_first = first;
  poses.tendon_points = counts;
  poses.path_points = points;
  poses.path_objects = kinds;
  poses.path_count = 5;
  poses.extra_count = 1;
  poses.extra_forms = &cube;
  poses.extra_sizes = size;
  poses.extra_positions = place;
  poses.extra_rotations = upright;
  poses.extra_colors = white;
  poses.extra_objects = name;
  draw(stage, &poses, &view);
  CHECK_NEAR(4.95, depth[MIDDLE], 1e-5);
  CHECK(objects[2 * MIDDLE] == 0 && objects[2 * MIDDLE + 1] == 18);
  CHECK(objects[2 * (MIDDLE - half_metre * SIZE - 20)] == 1);
  CHECK(objects[2 * (MIDDLE - half_metre * SIZE + 20)] == -1); /* beyond the pulley */
  CHECK(objects[2 * (MIDDLE + half_metre * SIZE)] == 3 && objects[2 * (MIDDLE + half_metre * SIZE) + 1] == 4);
  CHECK_NEAR(4.95, depth[MIDDLE + half_metre * SIZE], 1e-5);
  mimo_stage_destroy(stage);
}

/* ---- Cameras, buffers, threads ---- */

/* A principal point 10 pixels aside moves the picture by 10 pixels; other focal lengths scale it. */
static void test_intrinsics(void) {
  const int32_t form = MIMO_FORM_BOX;
  const double size[3] = {0.5, 0.25, 0.5};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  mimo_stage_view view = from(above);
  mimo_stage* stage = stage_of(&geoms);
  size_t usual;
  draw(stage, &poses, &view);
  usual = pixels_of(0, 5);
  CHECK(objects[2 * (MIDDLE + 62)] == 0 && objects[2 * (MIDDLE + 66)] == -1); /* f / 9 = 63.3 */
  view.fovy = 0;                                                              /* which does not count then */
  view.focal_x = view.focal_y = focal();
  view.center_x = 0.5 * SIZE + 10;
  view.center_y = 0.5 * SIZE;
  draw(stage, &poses, &view);
  CHECK_NEAR((double)usual, (double)pixels_of(0, 5), 0);
  CHECK(objects[2 * (MIDDLE + 72)] == 0 && objects[2 * (MIDDLE + 76)] == -1 && objects[2 * (MIDDLE - 56)] == -1);
  view.focal_x = 0.5 * focal();
  draw(stage, &poses, &view);
  CHECK_NEAR(0.5 * (double)usual, (double)pixels_of(0, 5), 70); /* it is 63 pixels high */
  mimo_stage_destroy(stage);
}

/* Parallel rays: a box 1 x .5 x 1 m shows as wide wherever it is, and its top is as far away all over. */
static void test_orthographic(void) {
  const int32_t form = MIMO_FORM_BOX;
  const double size[3] = {0.5, 0.25, 0.5}, far_away[3] = {0, 0, 30};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  mimo_stage_view view = from(above);
  mimo_stage* stage = stage_of(&geoms);
  const size_t expected = 101 * 51; /* 201 pixels are 2 m: half of the box is 50.25 and 25.125 pixels of the middle */
  view.ortho_height = 2;
  draw(stage, &poses, &view);
  CHECK_NEAR((double)expected, (double)pixels_of(0, 5), 1e-9);
  CHECK(objects[2 * (MIDDLE + 50)] == 0 && objects[2 * (MIDDLE + 51)] == -1);
  CHECK_NEAR(4.5, depth[MIDDLE], 1e-5);
  CHECK_NEAR(4.5, depth[MIDDLE + 50], 1e-5);
  view.position = far_away;
  draw(stage, &poses, &view);
  CHECK_NEAR((double)expected, (double)pixels_of(0, 5), 1e-9);
  CHECK_NEAR(29.5, depth[MIDDLE], 1e-4);
  view.focal_x = view.focal_y = 100;
  {
    const mimo_stage_poses* where = &poses;
    const mimo_stage_view* seen = &view;
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "ortho_height is 2, but focal lengths are given",
                mimo_stage_draw(stage, &where, 1, &seen, 1));
  }
  mimo_stage_destroy(stage);
}

/* Rows that lie farther apart: what is between them stays. */
static void test_strides(void) {
  enum { ROW = 3 * SIZE + 5 };
  static uint8_t wide[ROW * SIZE];
  const int32_t form = MIMO_FORM_SPHERE;
  const double size[3] = {0.5, 0, 0};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  mimo_stage_view view = from(above);
  mimo_stage* stage = stage_of(&geoms);
  int row, k;
  draw(stage, &poses, &view);
  memset(wide, 0xab, sizeof wide);
  view.rgb = wide;
  view.rgb_bytes = sizeof wide;
  view.rgb_stride = ROW;
  draw(stage, &poses, &view);
  for (row = 0; row < SIZE; ++row) {
    CHECK(memcmp(wide + row * ROW, rgb + 3 * row * SIZE, 3 * SIZE) == 0);
    for (k = 3 * SIZE; k < ROW; ++k) CHECK(wide[row * ROW + k] == 0xab);
  }
  mimo_stage_destroy(stage);
}

/* Four poses seen by two cameras each, on three threads and on one, are the same as one by one. */
static void test_batch(void) {
  enum { POSES = 4, VIEWS = 8, SMALL = 64, BYTES = 3 * SMALL * SMALL };
  static uint8_t pictures[2][VIEWS][BYTES], alone[BYTES];
  static double places[POSES][3];
  static const double aside[3] = {0.2, 0.1, 4};
  const int32_t form = MIMO_FORM_ELLIPSOID;
  const double size[3] = {0.5, 0.3, 0.2};
  const mimo_stage_shapes geoms = one_shape(&form, size);
  mimo_stage_poses poses[POSES];
  mimo_stage_view views[VIEWS];
  const mimo_stage_poses* all_poses[POSES];
  const mimo_stage_view* all_views[VIEWS];
  int threads, i;
  for (i = 0; i < POSES; ++i) {
    places[i][0] = 0.1 * i;
    poses[i] = one_geom();
    poses[i].geom_positions = places[i];
    all_poses[i] = &poses[i];
  }
  for (threads = 0; threads < 2; ++threads) {
    mimo_stage_config config = empty_stage();
    mimo_stage* stage = NULL;
    config.geoms = &geoms;
    config.threads = threads == 0 ? 1 : 3;
    CHECK_OK(mimo_stage_create(&config, &stage));
    for (i = 0; i < VIEWS; ++i) {
      views[i] = from(i % 2 == 0 ? above : aside);
      views[i].pose = (uint32_t)(i / 2);
      views[i].width = views[i].height = SMALL;
      views[i].depth = NULL;
      views[i].segmentation = NULL;
      views[i].depth_count = views[i].segmentation_count = 0;
      views[i].rgb = pictures[threads][i];
      views[i].rgb_bytes = BYTES;
      all_views[i] = &views[i];
    }
    CHECK_OK(mimo_stage_draw(stage, all_poses, POSES, all_views, VIEWS));
    for (i = 0; i < VIEWS; ++i) {
      mimo_stage_view one = views[i];
      one.pose = 0;
      one.rgb = alone;
      draw(stage, &poses[i / 2], &one);
      CHECK(memcmp(alone, pictures[threads][i], BYTES) == 0);
    }
    mimo_stage_destroy(stage);
  }
  CHECK(memcmp(pictures[0], pictures[1], sizeof pictures[0]) == 0);
  CHECK(memcmp(pictures[0][0], pictures[0][2], BYTES) != 0 && memcmp(pictures[0][0], pictures[0][1], BYTES) != 0);
}

/* ---- Changes and messages ---- */

static void test_update(void) {
  static const float red[4] = {1, 0, 0, 1};
  const int32_t form = MIMO_FORM_SPHERE, material = 0;
  const double size[3] = {0.5, 0, 0};
  mimo_stage_shapes geoms = one_shape(&form, size);
  const mimo_stage_poses poses = one_geom();
  const mimo_stage_view view = from(above);
  mimo_stage_config change = empty_stage();
  mimo_stage* stage = stage_of(&geoms);
  draw(stage, &poses, &view);
  CHECK(rgb[3 * MIDDLE] > 0 && rgb[3 * MIDDLE + 1] == rgb[3 * MIDDLE]);
  geoms.colors = red;
  change.geoms = &geoms;
  CHECK_OK(mimo_stage_update(stage, &change));
  draw(stage, &poses, &view);
  CHECK(rgb[3 * MIDDLE] > 2 * rgb[3 * MIDDLE + 1]);
  memcpy(other, rgb, sizeof rgb);
  geoms.colors = white;
  geoms.materials = &material; /* of which there is none */
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "geoms: materials[0] is 0, expected -1, or a material, of which there is none",
              mimo_stage_update(stage, &change));
  draw(stage, &poses, &view);
  CHECK(memcmp(other, rgb, sizeof rgb) == 0);
  mimo_stage_destroy(stage);
}

static char told[1024];

static void tell(void* user, const mimo_log_record* record) {
  ++*(int*)user;
  strncat(told, record->text, sizeof told - strlen(told) - 2);
  strcat(told, "\n");
}

static void test_omissions(void) {
  static const int32_t forms[2] = {MIMO_FORM_SPHERE, 9}, image = 3;
  static const double sizes[6] = {0.5, 0, 0, 0.5, 0, 0};
  static const float colors[8] = {1, 1, 1, 1, 1, 1, 1, 1}, dim[3] = {0.1F, 0.1F, 0.1F};
  mimo_stage_shapes geoms = one_shape(forms, sizes);
  const mimo_stage_lights lights = one_light(&image, dim, dim);
  mimo_stage_config config = empty_stage();
  mimo_stage* stage = NULL;
  int count = 0;
  geoms.count = 2;
  geoms.colors = colors;
  config.geoms = &geoms;
  config.lights = &lights;
  config.log = tell;
  config.log_user = &count;
  CHECK_OK(mimo_stage_create(&config, &stage));
  CHECK(count == 2);
  CHECK(strstr(told, "geom 1 is not drawn: its form is 9") != NULL);
  CHECK(strstr(told, "light 0 is not drawn: its type is 3") != NULL);
  config.log = NULL;
  CHECK_OK(mimo_stage_update(stage, &config));
  CHECK(count == 2); /* once */
  mimo_stage_destroy(stage);
}

int main(void) {
  test_sphere();
  test_box();
  test_rotations();
  test_groups();
  test_lambert();
  test_mesh();
  test_srgb();
  test_field();
  test_surfaces();
  test_tendons_and_extras();
  test_intrinsics();
  test_orthographic();
  test_strides();
  test_batch();
  test_update();
  test_omissions();
  return failures();
}
