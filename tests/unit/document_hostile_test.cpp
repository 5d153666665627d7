// Documents and files that lie: each is refused with one line that names file and line, before MuJoCo's compiler, which
// would crash, fill the memory or never come back, sees it. The fixture looks at what is printed.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "repository_paths.h"
#include "support/files.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using SceneHostile = QuietTest;

const std::string kBall = "<worldbody><geom size='1'/></worldbody>";

void expect_refused(const scene::Source& source, const std::string& what) {
  const auto start = std::chrono::steady_clock::now();
  expect_error(Status::kModel, what, [&] { compile(scene::Scene(source)); });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 20) << what;
}

// The second line of a text.
void expect_refused(const std::string& parts, const std::string& what) {
  expect_refused(from_text("<mujoco>\n" + parts + kBall + "</mujoco>"), what);
}

// Bytes of numbers as they lie in files.
template <typename... Numbers>
std::string bytes(Numbers... numbers) {
  std::string all;
  (all.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return all;
}

std::string floats(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

const std::vector<float> kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};  // of a tetrahedron

std::string stl(const std::vector<std::vector<float>>& faces) {
  std::string all = std::string(80, ' ') + bytes(static_cast<std::uint32_t>(faces.size()));
  for (const std::vector<float>& face : faces) all += floats({0, 0, 1}) + floats(face) + std::string(2, '\0');
  return all;
}

// A file of a user's beside the document that names it.
class Room {
 public:
  explicit Room(const std::string& asset, const std::string& geom = "<geom size='1'/>")
      : path_(folder_.write("room.xml",
                            "<mujoco>\n<asset>\n" + asset + "</asset><worldbody>" + geom + "</worldbody></mujoco>")) {}
  const Folder& folder() const { return folder_; }
  scene::Source source() const { return from_file(path_); }
  void expect(const std::string& file, const std::string& content, const std::string& what) const {
    folder_.write(file, content);
    expect_refused(source(), "line 3: ");
    expect_refused(source(), what);
  }

 private:
  Folder folder_;
  std::string path_;
};

TEST_F(SceneHostile, PicturesThatAreTooLarge) {
  expect_refused("<asset><texture type='2d' builtin='flat' width='65536' height='65536'/></asset>",
                 "xml text, line 2: <texture> of 65536 x 65536 pixels, more than max_pixels (67108864)");
  expect_refused("<asset><texture type='skybox' builtin='flat' width='30000' height='1'/></asset>", "max_pixels");
  expect_refused("<asset><hfield nrow='2147483647' ncol='2' size='1 1 1 1'/></asset>", "max_pixels");
  expect_refused("<asset><hfield nrow='65536' ncol='65536' size='1 1 1 1'/></asset>", "max_pixels");
  expect_refused("<asset><texture type='cube' file='none.png' gridsize='65536 65536'/></asset>", "gridsize");
  expect_refused("<visual><quality shadowsize='100000000'/></visual>", "<quality> of 100000000 x 100000000 pixels");
}

TEST_F(SceneHostile, LimitsCanBeRaisedAndLowered) {
  scene::Source source =
      from_text("<mujoco><asset><texture name='t' type='2d' builtin='flat' width='100' height='100'/></asset>" + kBall +
                "</mujoco>");
  EXPECT_EQ(compile(scene::Scene(source))->ntex, 1);
  source.limits.pixels = 9999;
  expect_refused(source, "more than max_pixels (9999)");
  source.limits.pixels = 10000;
  EXPECT_EQ(compile(scene::Scene(source))->ntex, 1);
}

TEST_F(SceneHostile, PictureFilesWithFalseSizes) {
  const Room raw("<texture type='2d' file='a.bin'/>");
  raw.expect("a.bin", bytes(65536, 65536), "another size than its header says");  // 3 * 2^32 is 0 in 32 bits
  raw.expect("a.bin", bytes(2, 2) + "rgb", "another size");
  raw.expect("a.bin", bytes(-1, 2), "below 1");
  raw.expect("a.bin", "abc", "too short");
  const Room heights("<hfield file='a.bin' size='1 1 1 1'/>");
  heights.expect("a.bin", bytes(65536, 65536), "another size");
  heights.expect("a.bin", bytes(32768, 32768), "another size");
  const Room png("<texture type='2d' file='a.png'/>");
  const auto header = [](const char* size) {
    return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(size, 8) +
           std::string("\x08\x02\0\0\0crc!", 9);
  };
  png.expect("a.png", "abc", "is no PNG");
  png.expect("a.png", header("\0\1\0\0\0\1\0\0"), "65536 x 65536 pixels, more than max_pixels");
  png.expect("a.png", header("\0\0\0\1\0\0\0\1") + std::string("\0\1\x86\xa0IDAT", 8) + std::string(100004, 'x'),
             "more data than its size says");
  png.expect("a.png", header("\0\0\0\1\0\0\0\1") + std::string("\x7f\1\x86\xa0IDAT", 8) + std::string(99, 'x'),
             "ends within");
}

// A kilobyte may become a megabyte, and a megabyte a gigabyte, before MuJoCo's reader looks at the size.
TEST_F(SceneHostile, PicturesThatGrowWhenTheyAreRead) {
  const Room png("<texture type='2d' file='a.png'/>");
  const auto number = [](std::size_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255U);
    return bytes;
  };
  const auto chunk = [&](const std::string& kind, const std::string& content) {
    const std::string named = kind + content;
    const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
    return number(content.size()) + named + number(sum);
  };
  const auto picture = [&](std::size_t side, const std::string& rows, std::size_t parts) {
    std::string packed(compressBound(rows.size()), '\0');
    uLongf length = packed.size();
    compress(reinterpret_cast<Bytef*>(&packed[0]), &length, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
    std::string data;
    for (std::size_t i = 0; i < parts; ++i) {
      const std::size_t first = length * i / parts, last = length * (i + 1) / parts;
      data += chunk("IDAT", packed.substr(first, last - first));
    }
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", number(side) + number(side) + std::string("\x08\x02\0\0\0", 5)) + data +
           chunk("IEND", "");
  };
  const std::size_t side = 100, whole = side * (3 * side + 1);
  for (const std::size_t parts : {1, 7}) {
    png.expect("a.png", picture(side, std::string(whole * 1000, '\0'), parts), "more data than its size says");
  }
  png.folder().write("a.png", picture(side, std::string(whole, '\0'), 7));
  EXPECT_EQ(compile(scene::Scene(png.source()))->ntex, 1);
}

TEST_F(SceneHostile, MeshFilesWithFalseSizes) {
  const Room msh("<mesh file='a.msh'/>");
  const std::string corners = floats(kCorners);
  msh.expect("a.msh", bytes(4, 0, 0, 1) + corners + bytes(0, 1, 1000000), "a face at vertex 1000000, but 4 vertices");
  msh.expect("a.msh", bytes(4, 0, 0, 1) + corners + bytes(0, 1, -1), "a face at vertex -1");
  msh.expect("a.msh", bytes(4, 0, 0, 2) + corners + bytes(0, 1, 2), "another size");
  msh.expect("a.msh", bytes(1431655766, 0, 0, 0) + floats({0, 0}), "max_vertices");  // 12 times that is 8 in 32 bits
  const Room obj("<mesh file='a.obj'/>");
  const std::string four = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  obj.expect("a.obj", four + "f 1 2 5\n", "a face at vertex 5, but there are 4");
  obj.expect("a.obj", four + "f 1 2 -9\n", "a face at vertex -4");
  obj.expect("a.obj", four + "f 1 2 99999999999999999999\n", "a face at vertex");
  obj.expect("a.obj", four + "v\nf 1 2 5\n", "a face at vertex 5, but there are 4");
  obj.expect("a.obj", four + "vn 0 0 1\nf 1//1 2//1 3//9\n", "a face at normal 9, but there are 1");
  obj.expect("a.obj", four + "vn 0 0 1\nf 1 2 3\n", "without a normal");
  obj.expect("a.obj", four + "vt 0 0\nf 1/1 2/1 3/7\n", "a face at texture point 7");
  obj.expect("a.obj", four + "vn 0 0 1\n", "no faces, and not as many normals");
  obj.expect("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "is flat");
  obj.expect("a.obj", four + "v nan 0 0\nf 1 2 5\nf 2 3 4\n", "finite");
  obj.expect("a.obj", four + "mtllib /../../../../../../../../../../../dev/zero\nf 1 2 3\n", "is a device");
  const Room faces("<mesh file='a.stl'/>");
  faces.expect("a.stl", std::string(80, ' ') + bytes(0xffffffffu), "another size");
  faces.expect("a.stl", "thin_mesh ascii", "too short");
  faces.expect("a.stl", stl({{0, 0, 0, 1, 0, 0, 0, 1, HUGE_VALF}}), "finite");
  expect_refused("<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 1 7'/></asset>",
                 "a face at vertex 7, but 4 vertices");
}

TEST_F(SceneHostile, SkinFilesWithFalseSizes) {
  const Room skin("<skin file='a.skn'/>");
  const std::string corners = floats(kCorners), bone = std::string(40, 'b') + std::string(28, '\0');
  const auto whole = [&](int third, int count) {
    return bytes(4, 0, 1, 1) + corners + bytes(0, 1, third) + bone + bytes(count);
  };
  skin.expect("a.skn", whole(4, 1) + bytes(0, 1.0f), "a face at vertex 4, but 4 vertices");
  skin.expect("a.skn", whole(2, 1 << 30) + bytes(0, 1.0f), "ends within a bone");  // twice that is below 0 in 32 bits
  skin.expect("a.skn", bytes(178956970, 0, 0, 0), "max_vertices");
  expect_refused("<asset><skin vertex='0 0 0 1 0 0 0 1 0' face='0 1 3'/></asset>", "a face at vertex 3");
}

// Qhull prints to the host's stderr where points lie in a plane.
TEST_F(SceneHostile, FlatMeshesHaveNoHull) {
  const std::vector<std::vector<float>> square = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}};
  const Room touched("<mesh name='m' file='a.stl'/>", "<geom type='mesh' mesh='m'/>");
  touched.expect("a.stl", stl(square), "mesh \"m\" is flat");
  const Room points("<mesh name='m' vertex='0 0 0 1 0 0 0 1 0 1 1 0 .5 .5 1e-8'/>");
  expect_refused(points.source(), "mesh \"m\" is flat");
  const Room line("<mesh name='m' vertex='0 0 0 1 1 1 2 2 2 3 3 3'/>");
  expect_refused(line.source(), "is flat");
  const Room same("<mesh name='m' vertex='1 1 1 1 1 1 1 1 1 1 1 1'/>");
  expect_refused(same.source(), "is flat");
#if MIMO_MUJOCO_4  // which wants a volume of meshes that carry a mass, unless they are shells
  const char* const thin_mesh = "<mesh name='m' inertia='shell' vertex='0 0 0 1 0 0 0 1 0 1 1 0 .5 .5 1e-5'/>";
  const char* const sheet = "<mesh name='m' inertia='shell' file='a.stl'/>";
#else
  const char* const thin_mesh = "<mesh name='m' vertex='0 0 0 1 0 0 0 1 0 1 1 0 .5 .5 1e-5'/>";
  const char* const sheet = "<mesh name='m' file='a.stl'/>";
#endif
  const Room thin(thin_mesh, "<geom type='mesh' mesh='m'/>");
  EXPECT_EQ(compile(scene::Scene(thin.source()))->nmesh, 1);
  const Room seen(sheet, "<geom type='mesh' mesh='m' contype='0' conaffinity='0' mass='1'/>");
  seen.folder().write("a.stl", stl(square));
  EXPECT_EQ(compile(scene::Scene(seen.source()))->nmesh, 1);
}

TEST_F(SceneHostile, NumbersThatNeverEnd) {
  expect_refused("<option iterations='2147483647' tolerance='0'/>",
                 "line 2: iterations=\"2147483647\" is more than max_iterations");
  expect_refused("<option noslip_iterations='2147483647'/>", "max_iterations");
  expect_refused("<option mpr_iterations='2147483647'/>", "max_iterations");
  expect_refused("<compiler><lengthrange inttotal='1e9' timestep='1e-9'/></compiler>", "lengthrange");
  std::string keys;
  for (int i = 0; i < 10001; ++i) keys += "<key/>";
  expect_refused("<keyframe>" + keys + "</keyframe>", "10001 keyframes, more than max_keyframes (10000)");
  expect_refused("<size nkey='2147483647'/>", "max_keyframes");
  expect_refused(
      "<worldbody><body><composite type='particle' count='100 100 100' spacing='.1'><geom size='.01'/>"
      "</composite></body></worldbody>",
      "max_elements (40000)");
  expect_refused("<custom><numeric name='n' size='2147483647' data='1'/></custom>", "expected at most 500");
  std::string numbers;
  for (int i = 0; i < 600; ++i) numbers += "1 ";
  expect_refused("<custom><numeric name='n' size='600' data='" + numbers + "'/></custom>", "expected at most 500");
}

TEST_F(SceneHostile, BuffersThatFillTheMemory) {
  for (const char* size : {"nconmax='2147483647'", "njmax='2147483647'", "nstack='2147483647'", "njmax='100000'",
                           "nuserdata='2147483647'", "nuser_geom='2147483647'"}) {
    expect_refused("<size " + std::string(size) + "/>", "more than max_world_bytes (4294967296)");
  }
}

TEST_F(SceneHostile, InvalidTimeSteps) {
  for (const char* step : {"0", "-0.01", "nan", "inf", "-inf"}) {
    expect_refused("<option timestep='" + std::string(step) + "'/>", std::string("line 2: timestep=\"") + step);
  }
}

TEST_F(SceneHostile, PathsThatAreNotFiles) {
  const Folder folder;
  ASSERT_EQ(::mkfifo(folder.path("pipe.xml").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo(folder.path("pipe.png").c_str(), 0600), 0);
  ASSERT_EQ(::mkdir(folder.path("folder.stl").c_str(), 0700), 0);
  ASSERT_EQ(::symlink("/dev/zero", folder.path("zero.png").c_str()), 0);
  const auto with = [&](const std::string& part) {
    return from_file(folder.write("room.xml", "<mujoco>\n" + part + "</mujoco>"));
  };
  expect_refused(with("<include file='pipe.xml'/>"), "is a pipe");
  expect_refused(with("<include file='/dev/zero'/>"), "is a device");
  expect_refused(with("<include file='folder.stl'/>"), "is a folder");
  expect_refused(with("<asset><texture type='2d' file='pipe.png'/></asset>"),
                 "room.xml, line 2: file " + folder.path("pipe.png") + " is a pipe");
  expect_refused(with("<asset><texture type='2d' file='zero.png'/></asset>"), "is a device");
  expect_refused(with("<asset><mesh file='folder.stl'/></asset>"), "is a folder");
  expect_refused(with("<asset><mesh file='m'/></asset>"), "cannot be read");
  expect_refused(from_file("/dev/zero"), "is a device");
  scene::Source source = with(kBall);
  source.limits.file_bytes = 10;
  expect_refused(source, "bytes, more than max_file_bytes (10)");
}

TEST_F(SceneHostile, IncludesInIncludes) {
  const Folder folder;
  for (int i = 0; i < 200; ++i) {
    folder.write(std::to_string(i) + ".xml", "<mujoco><include file='" + std::to_string(i + 1) + ".xml'/></mujoco>");
  }
  folder.write("200.xml", "<mujoco/>");
  expect_refused(from_file(folder.path("0.xml")), "included more than 100 deep");
  // Each file is shallow, what they make together is not.
  std::string opening, closing;
  for (int i = 0; i < 200; ++i) {
    opening += "<body>";
    closing += "</body>";
  }
  folder.write("a.xml",
               "<mujoco><worldbody>" + opening + "<include file='b.xml'/>" + closing + "</worldbody></mujoco>");
  folder.write("b.xml", "<mujoco>" + opening + closing + "</mujoco>");
  expect_refused(from_file(folder.path("a.xml")), "nested more than 256 deep");
}

TEST_F(SceneHostile, ConfinedToItsFolder) {
  const Folder folder;
  folder.write("secret.xml", "<mujoco>" + kBall + "</mujoco>");
  folder.copy_of(std::string(MIMO_MODELS) + "/textures/ball_c.png", "secret.png");
  folder.copy_of(std::string(MIMO_MODELS) + "/textures/ball_c.png", "room/mine.png");
  ASSERT_EQ(::symlink("../secret.png", folder.path("room/link.png").c_str()), 0);
  const auto with = [&](const std::string& part) {
    scene::Source source = from_file(folder.write("room/room.xml", "<mujoco>\n" + part + "</mujoco>"));
    source.limits.confined = true;
    return source;
  };
  const auto texture = [](const std::string& file) {
    return "<asset><texture type='2d' file='" + file + "'/></asset>" + kBall;
  };
  expect_refused(with("<include file='../secret.xml'/>"), "line 2: file ");
  expect_refused(with("<include file='" + folder.path("secret.xml") + "'/>"), "lies outside the document's folder");
  for (const char* file : {"../secret.png", "link.png", "mimo/../../secret.png"}) {
    expect_refused(with(texture(file)), "lies outside the document's folder");
  }
  EXPECT_EQ(compile(scene::Scene(with(texture("mine.png"))))->ntex, 1);
  EXPECT_EQ(compile(scene::Scene(with("<include file='mimo/mitten.xml'/>")))->nu, 44);
  scene::Source free = with(texture("../secret.png"));
  free.limits.confined = false;
  EXPECT_EQ(compile(scene::Scene(free))->ntex, 1);
}

// MuJoCo sees one document that was composed; its messages name what the user wrote.
TEST_F(SceneHostile, MessagesNameTheUsersLines) {
  const Folder folder;
  folder.write("parts/arm.xml",
               "<!-- an arm -->\n<mujocoinclude>\n  <worldbody>\n    <body>\n      <joint limited='sometimes'/>\n"
               "    </body>\n  </worldbody>\n</mujocoinclude>\n");
  const std::string path =
      folder.write("room.xml", "<mujoco>\n<include file='parts/arm.xml'/>\n" + kBall + "</mujoco>");
  const std::string place = folder.path("parts/arm.xml") + ", line 5: ";
  expect_refused(from_file(path), place);
  const Error error = error_of([&] { compile(scene::Scene(from_file(path))); });
  EXPECT_EQ(error.message(), place + "XML Error: invalid keyword: 'sometimes' Element 'joint'");

  // What the compiler finds when it has read everything, and with an infant before it.
  scene::Scene scene(from_file(folder.write("b.xml",
                                            "<mujoco>\n\n<worldbody>\n<body>\n<geom name='stone' size='-1'/>\n"
                                            "</body></worldbody></mujoco>")));
  scene.add_body("mitten", "", nullptr);
  expect_error(Status::kModel, folder.path("b.xml") + ", line 5: Error: ", [&] { compile(scene); });

  // Of an object's document.
  scene::Scene room(named("free"));
  scene::Model model;
  model.name = "chair";
  model.file =
      folder.write("chair.xml", "<mujoco><worldbody>\n<body>\n<geom size='wide'/></body></worldbody></mujoco>");
  room.add_model(model);
  expect_error(Status::kModel, model.file + ", line 3: XML Error", [&] { compile(room); });
}

}  // namespace
}  // namespace mimo::test
