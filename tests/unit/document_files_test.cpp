// Files as other programs write them: taken as MuJoCo takes them, or refused with what there is to do.
#include <gtest/gtest.h>

#include <string>

#include "support/files.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using SceneFiles = QuietTest;

const std::string kBall = "<worldbody><geom size='1'/></worldbody>";
const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string kFaces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

// A document with a tetrahedron of a file that stands free.
std::string with_mesh(const std::string& file, const std::string& compiler = "") {
  return "<mujoco><compiler " + compiler + "/><asset><mesh file='" + file +
         "'/></asset><worldbody><body><freejoint/><geom type='mesh' mesh='m'/></body></worldbody></mujoco>";
}

TEST_F(SceneFiles, FoldersOfWindowsAreStripped) {
  const Folder folder;
  folder.write("meshes/m.obj", kCorners + kFaces);
  for (const char* path : {"C:\\Users\\anna\\m.obj", "parts\\m.obj", "/home/anna\\parts/m.obj", "/home/anna/m.obj"}) {
    const std::string document = with_mesh(path, "meshdir='meshes' strippath='true'");
    EXPECT_EQ(compile(scene::Scene(from_file(folder.write("room.xml", document))))->nmesh, 1) << path;
  }
}

// MuJoCo looks at what an included file's root holds, not at what it is called.
TEST_F(SceneFiles, IncludedRootsHaveAnyName) {
  const Folder folder;
  const auto with = [&](const std::string& included, const std::string& document) {
    folder.write("part.xml", included);
    return from_file(folder.write("room.xml", document));
  };
  const std::string inside = "<mujoco><worldbody>\n<include file='part.xml'/></worldbody></mujoco>";
  for (const char* root : {"worldbody", "body", "part", "mujoco", "mujocoinclude"}) {
    const std::string name = root, part = "<" + name + "><geom size='1'/><geom size='2'/></" + name + ">";
    EXPECT_EQ(compile(scene::Scene(with(part, inside)))->ngeom, 2) << name;
  }
  const auto refused = [&](const std::string& included, const std::string& what) {
    expect_error(Status::kModel, what, [&] { scene::Scene(with(included, inside)); });
  };
  refused("<include file='part.xml'/>", "part.xml: the root element is <include>, which holds nothing to include");
  refused("<!-- nothing -->", "part.xml, line 1: No document element found");
  refused("<geom size='1'/>", "part.xml: the root element is <geom>, which holds nothing to include");
  refused("<body><geom size='1'/></body><geom size='2'/>",
          "part.xml: <geom> stands beside the root element, which is <body>");
  expect_error(Status::kModel, "the root element is <worldbody>, but MJCF has <mujoco>",
               [&] { scene::Scene(with("", "<worldbody><geom size='1'/></worldbody>")); });
}

TEST_F(SceneFiles, PicturesInOtherFormatsAreNamed) {
  const Folder folder;
  const std::string jpeg("\xff\xd8\xff\xe0\0\x10JFIF\0\1\1", 13);
  const auto refused = [&](const std::string& asset, const std::string& file, const std::string& bytes,
                           const std::string& what) {
    folder.write(file, bytes);
    const auto source = from_file(folder.write(
        "room.xml", "<mujoco>\n<asset>\n" + asset + " file='" + file + "'/></asset>" + kBall + "</mujoco>"));
    expect_error(Status::kModel, "room.xml, line 3: file " + folder.path(file) + " of <",
                 [&] { compile(scene::Scene(source)); });
    expect_error(Status::kModel, what, [&] { compile(scene::Scene(source)); });
  };
  const std::string texture = "<texture type='2d'";
  refused(texture, "photo.jpg", jpeg, "is a JPEG picture, expected PNG");
  refused(texture, "photo.png", jpeg, "is a JPEG picture, expected PNG");
  refused("<texture type='cube'", "photo.jpeg", jpeg, "is a JPEG picture, expected PNG");
  refused("<hfield size='1 1 1 1'", "photo.jpg", jpeg, "is a JPEG picture, expected PNG");
  refused(texture, "a.bmp", std::string("BM\x36\0\0\0\0\0\0\0", 10), "is a BMP picture, expected PNG");
  refused(texture, "a.webp", std::string("RIFF\x20\0\0\0WEBPVP8 ", 16), "is a WebP picture, expected PNG");
  refused(texture, "a.gif", "GIF89a..........", "is a GIF picture, expected PNG");
  refused(texture, "a.tga", "\x89PNG\r\n\x1a\n........", "is a PNG picture, but its name does not end in .png");
}

// Without the mark: the mass of a tetrahedron with corners at the origin and at 1 on each axis is a sixth of 1000 kg.
TEST_F(SceneFiles, MarksOfUtf8BeforeMeshes) {
  const Folder folder;
  const auto mass = [&](const std::string& content, const char* ending) {
    folder.write(std::string("m") + ending, content);
    const std::string document = with_mesh(std::string("m") + ending, "exactmeshinertia='true'");
    const auto model = compile(scene::Scene(from_file(folder.write("room.xml", document))));
    return model->body_mass[1];
  };
  EXPECT_NEAR(mass("\xef\xbb\xbf" + kCorners + kFaces, ".obj"), 1000.0 / 6, 1e-3);
  EXPECT_EQ(mass(kCorners + kFaces, ".obj"), mass("\xef\xbb\xbf" + kCorners + kFaces, ".OBJ"));
}

TEST_F(SceneFiles, LinesOfMeshes) {
  const Folder folder;
  const auto refused = [&](const std::string& content, const std::string& what) {
    folder.write("m.obj", content);
    const auto source = from_file(folder.write("room.xml", with_mesh("m.obj")));
    expect_error(Status::kModel, what, [&] { compile(scene::Scene(source)); });
  };
  const std::string points = "vt 0 0\nvt 1 0\nvt 0 1\n";
  refused(kCorners + points + "f 1/1 3/2 2/3\nf 1 2 4\n",
          "m.obj of <mesh> has, in line 9, a corner of a face without a texture point");
  refused(kCorners + "vn 0 0 1\r\nf 1//1 3//1 2//1\r\nf 1//1 2 4//1\r\n",
          "has, in line 7, a corner of a face without a normal");
  refused("# 1\n\n\n" + kCorners + "f 1 2 9\n", "has, in line 8, a face at vertex 9, but there are 4");
}

// Cut into triangles, this face loses corners; what is left is flat, and would have no hull.
TEST_F(SceneFiles, FacesOfManyCorners) {
  const Folder folder;
  const auto source = [&](const std::string& content) {
    folder.write("m.obj", content);
    return from_file(folder.write("room.xml", with_mesh("m.obj")));
  };
  expect_error(Status::kModel,
               "room.xml, line 1: ", [&] { compile(scene::Scene(source(kCorners + "f 1 2 3 4 1 2 3 4\n"))); });
  // A pyramid on a pentagon.
  const std::string pyramid = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv .5 1.5 0\nv 0 1 0\nv .5 .5 1\n";
  EXPECT_EQ(
      compile(scene::Scene(source(pyramid + "f 5 4 3 2 1\nf 1 2 6\nf 2 3 6\nf 3 4 6\nf 4 5 6\nf 5 1 6\n")))->nmesh, 1);
}

// Flat once they are scaled, or as floats: the library that makes convex hulls would write to stderr.
TEST_F(SceneFiles, MeshesThatBecomeFlat) {
  const auto refused = [](const std::string& mesh, const std::string& what, const std::string& before = "") {
    const auto source = from_text("<mujoco>" + before + "<asset><mesh name='m' " + mesh +
                                  "/></asset><worldbody><geom type='mesh' mesh='m'/></worldbody></mujoco>");
    expect_error(Status::kModel, what, [&] { compile(scene::Scene(source)); });
  };
  const std::string corners = "vertex='0 0 0 1 0 0 0 1 0 0 0 1'";
  refused(corners + " scale='1 1 0'", "is flat");
  refused(corners, "is flat", "<default><mesh scale='1 0 1'/></default>");
  refused(corners + " scale='1 1 1e-9'", "is flat");
  refused("vertex='1e7 0 0 10000000.1 0 0 1e7 1 0 1e7 0 1'", "is flat");
  refused("vertex='0 0 0 1 0 0 0 1 0 0 0 1 0 0 0' scale='1e30 1e30 1e30' refpos='1e39 0 0'", "refpos");
  refused(corners + " scale='1e39 1 1'", "a vertex at 1e+39, expected finite numbers");
  refused("vertex='0 0 0 0 0 0 1 0 0 1 0 0 0 1 0 0 1 0'", "is flat");
  refused("vertex='0 0 0 1 0 0 0 1 0 .3 .3 1e-6'", "is flat");
}

}  // namespace
}  // namespace mimo::test
