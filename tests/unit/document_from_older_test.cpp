// Documents of MuJoCo 2 on a newer one. What composites become is compared with what MuJoCo 2.2 itself makes of them,
// where that runs; where another does, with the sizes that Debian's mujoco 2.2.2 gives: its mj_loadXML of the same
// texts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "compat/mujoco.h"
#include "document/composites.h"
#include "document/other_versions.h"
#include "document/xml.h"
#include "support/quiet.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using SceneOlder = QuietTest;

struct Case {
  const char* name;
  std::string xml;
  std::array<int, 7> sizes;  // bodies, joints, geoms, sites, tendons, equalities, vertices of skins
};

// Main defaults and classes, which composites do not heed; what stands before and behind them.
std::string around(const std::string& body, const std::string& composite) {
  return "<mujoco><compiler autolimits='true'/><default><geom density='300' rgba='1 0 0 1'/><joint damping='7'/>"
         "<site size='.5'/><default class='soft'><geom solref='.1 1'/><equality solref='.2 1'/></default></default>"
         "<asset><material name='cloth' rgba='0 1 0 1'/></asset>"
         "<worldbody><body " +
         body + " childclass='soft'><freejoint/><geom name='own' size='.01'/>" + composite +
         "<body name='leaf' pos='0 0 2'><joint name='own' type='slide'/><geom size='.02'/></body></body></worldbody>"
         "<tendon><fixed name='own'><joint joint='own' coef='1'/></fixed></tendon>"
         "<equality><joint joint1='own'/></equality></mujoco>";
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"Particle",
       around("name='b'",
              "<composite type='particle' count='3 2 2' spacing='.1' offset='0 0 1'><joint damping='1' "
              "kind='main'/><geom size='.02' rgba='.8 .2 .1 1'/></composite>"),
       {15, 38, 14, 0, 1, 1, 0}},
      {"Grid",
       around("name='b'",
              "<composite prefix='n' type='grid' count='4 3 1' spacing='.1' offset='.1 0 1'><joint kind='main' "
              "damping='.1' range='-1 1' armature='.01'/><tendon kind='main' solreffix='.03' width='.004'/>"
              "<tendon kind='shear' stiffness='2' rgba='1 1 0 1'/><geom size='.02' mass='.1'/><site size='.01'/>"
              "<pin coord='0 0'/><pin coord='3 2'/><skin material='cloth' texcoord='true' "
              "inflate='.01'/></composite>"),
       {15, 32, 14, 12, 24, 24, 24}},
      {"Line",
       around("name='b'",
              "<composite type='grid' count='5 1 1' spacing='.1'><geom size='.02'/><pin coord='0'/>"
              "</composite>"),
       {8, 14, 7, 5, 5, 5, 0}},
      {"Rope",
       around("name='rB2'",
              "<composite prefix='r' type='rope' count='6 1 1' spacing='.1'><joint kind='main' "
              "stiffness='.01'/><joint kind='twist' damping='.2' solreffix='.05 .9'/><joint kind='stretch' "
              "solimpfix='.8'/><geom type='capsule' size='.02 .03' material='cloth'/></composite>"),
       {8, 22, 8, 0, 1, 11, 0}},
      {"Loop",
       around("name='B0'",
              "<composite type='loop' count='8 1 1' spacing='.1' solrefsmooth='.03'><geom type='ellipsoid' "
              "size='.02 .03 .02' group='2'/></composite>"),
       {10, 16, 10, 0, 1, 2, 0}},
      // A skin of halves, by which nothing is rounded: MuJoCo keeps bones' weights that are 0 but for rounding.
      {"Cloth",
       around("name='B1_2'",
              "<composite type='cloth' count='4 5 1' spacing='.1' flatinertia='.1'><joint kind='main' "
              "damping='.001'/><joint kind='twist'/><joint kind='stretch'/><tendon kind='shear'/><geom "
              "type='capsule' size='.02 .01' friction='.2'/><skin texcoord='true' subgrid='1' rgba='.5 .5 1 "
              "1' group='1'/></composite>"),
       {22, 78, 22, 20, 25, 63, 126}},
      {"Box",
       around("name='b'",
              "<composite type='box' count='3 4 3' spacing='.1'><joint kind='main' damping='3'/><tendon "
              "kind='main' stiffness='4'/><geom type='capsule' size='.02 .03'/><skin "
              "texcoord='true'/></composite>"),
       {37, 36, 37, 0, 2, 100, 66}},
      {"Cylinder",
       around("name='b'",
              "<composite type='cylinder' count='3 4 3' spacing='.1'><geom size='.02' mass='.01'/><skin "
              "texcoord='true'/></composite>"),
       {37, 36, 37, 0, 2, 100, 54}},
      {"Ellipsoid",
       around("name='b'",
              "<composite type='ellipsoid' count='4 3 5' spacing='.1' solimpsmooth='.8'><geom "
              "type='ellipsoid' size='.02 .01 .01'/><skin texcoord='true'/></composite>"),
       {57, 56, 57, 0, 2, 160, 54}},
  };
  return all;
}

std::array<int, 7> sizes_of(const mjModel& m) {
  return {static_cast<int>(m.nbody),    static_cast<int>(m.njnt),    static_cast<int>(m.ngeom),
          static_cast<int>(m.nsite),    static_cast<int>(m.ntendon), static_cast<int>(m.neq),
          static_cast<int>(m.nskinvert)};
}

engine::ModelPtr expanded(const std::string& xml) {
  const pugi::xml_document document = document::parse(xml, "text", document::Root::kMujoco);
  document::Report report;
  document::expand_composites(document.document_element(), {}, report);
  return engine::compile(document::print(document), {}, {});
}

class Composites : public testing::TestWithParam<Case> {};

TEST_P(Composites, HaveTheSizesOfMuJoCo2) { EXPECT_EQ(sizes_of(*expanded(GetParam().xml)), GetParam().sizes); }

#if !MIMO_MUJOCO_4

template <typename T>
void expect_equal(const char* name, const T* ours, const T* theirs, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_NEAR(static_cast<double>(ours[i]), static_cast<double>(theirs[i]),
                1e-6 * (1 + std::abs(static_cast<double>(theirs[i]))))
        << name << " " << i;
  }
}

TEST_P(Composites, EqualMuJoCo2sComposites) {
  const engine::ModelPtr mine = expanded(GetParam().xml), theirs = engine::compile(GetParam().xml, {}, {});
  const mjModel* m = theirs.get();
  MJMODEL_POINTERS_PREAMBLE(m)
#define X(name) ASSERT_EQ(mine->name, theirs->name) << #name;
  MJMODEL_INTS
#undef X
#define X(type, name, rows, columns) \
  expect_equal(#name, mine->name, theirs->name, static_cast<std::size_t>(m->rows) * static_cast<std::size_t>(columns));
  MJMODEL_POINTERS
#undef X
}

#endif

INSTANTIATE_TEST_SUITE_P(SceneOlder, Composites, testing::ValuesIn(cases()),
                         [](const auto& composite) { return composite.param.name; });

// The document after an upgrade, and its warnings.
struct Upgraded {
  pugi::xml_document document;
  std::vector<std::string> warnings;
  pugi::xml_node root() const { return document.document_element(); }
};

Upgraded upgraded(const std::string& xml) {
  Upgraded result;
  result.document = document::parse("<mujoco>" + xml + "</mujoco>", "text", document::Root::kMujoco);
  document::Report report;
  document::upgrade_older(result.root(), {}, report);
  report.write(LogSink([&result](const LogRecord& record) { result.warnings.push_back(record.text); }));
  return result;
}

std::string said(pugi::xml_node node, const char* attribute) { return node.attribute(attribute).value(); }

TEST_F(SceneOlder, RenamesSettings) {
  const Upgraded result = upgraded(
      "<compiler><lengthrange inteval='2'/></compiler><option mpr_iterations='7' mpr_tolerance='1e-7'><flag "
      "passive='disable'/></option>");
  const pugi::xml_node option = result.root().child("option"), flag = option.child("flag");
  EXPECT_EQ(said(result.root().child("compiler").child("lengthrange"), "interval"), "2");
  EXPECT_EQ(said(option, "ccd_iterations"), "7");
  EXPECT_EQ(said(option, "ccd_tolerance"), "1e-7");
  EXPECT_EQ(said(flag, "spring") + said(flag, "damper"), "disabledisable");
  for (const char* gone : {"mpr_iterations", "mpr_tolerance"}) EXPECT_TRUE(option.attribute(gone).empty());
  EXPECT_TRUE(flag.attribute("passive").empty());
  ASSERT_EQ(result.warnings.size(), 4u);
  EXPECT_NE(result.warnings[0].find("does not know the attribute inteval of <lengthrange>; it is interval now"),
            std::string::npos);
}

TEST_F(SceneOlder, OmitsSettingsWithoutEffect) {
  const Upgraded result = upgraded(
      "<compiler convexhull='false'/><option apirate='50'><flag sensornoise='enable'/></option><option apirate='60'/>");
  EXPECT_EQ(document::print(result.document).find("apirate"), std::string::npos);
  EXPECT_EQ(document::print(result.document).find("convexhull"), std::string::npos);
  EXPECT_EQ(document::print(result.document).find("sensornoise"), std::string::npos);
  ASSERT_EQ(result.warnings.size(), 3u) << "each kind once";
  EXPECT_NE(result.warnings[1].find("(and 1 more)"), std::string::npos) << result.warnings[1];
}

TEST_F(SceneOlder, CollisionsOfChosenPairs) {
  const std::string rest =
      "<worldbody><geom name='a' size='1'/><body><geom name='b' size='1' "
      "contype='3'/></body></worldbody><contact><pair "
      "geom1='a' geom2='b'/><exclude body1='world' body2='c'/></contact>";
  const Upgraded pairs = upgraded("<option collision='predefined'/>" + rest);
  for (const pugi::xpath_node geom : pairs.root().select_nodes("//geom")) {
    EXPECT_EQ(said(geom.node(), "contype") + said(geom.node(), "conaffinity"), "00");
  }
  EXPECT_FALSE(pairs.root().child("contact").child("pair").empty());
  const Upgraded others = upgraded("<option collision='dynamic'/>" + rest);
  EXPECT_TRUE(others.root().child("contact").child("pair").empty());
  EXPECT_FALSE(others.root().child("contact").child("exclude").empty());
  EXPECT_EQ(said(others.root().select_node("//body/geom").node(), "contype"), "3");
  EXPECT_EQ(upgraded("<option collision='all'/>" + rest).warnings.size(), 1u);
}

TEST_F(SceneOlder, MovesInertiaSettingsToMeshes) {
  const std::string rest =
      "<asset><mesh name='m' file='m.stl'/><mesh file='own.stl' inertia='convex'/></asset><worldbody><geom type='mesh' "
      "mesh='m' shellinertia='true'/><geom size='1' shellinertia='true'/></worldbody>";
  const Upgraded shells = upgraded(rest);
  EXPECT_EQ(said(shells.root().select_node("//mesh[1]").node(), "inertia"), "shell");
  EXPECT_EQ(said(shells.root().select_node("//worldbody/geom[1]").node(), "shellinertia"), "false");
  EXPECT_EQ(said(shells.root().select_node("//worldbody/geom[2]").node(), "shellinertia"), "true");
  const Upgraded exact = upgraded("<compiler exactmeshinertia='true'/><asset><mesh name='m' file='m.stl'/></asset>");
  EXPECT_EQ(said(exact.root().select_node("//mesh").node(), "inertia"), "exact");
  expect_error(Status::kModel, "shellinertia of one geom of mesh \"m\" and not of another", [&] {
    upgraded(
        "<asset><mesh name='m' file='m.stl'/></asset><worldbody><geom mesh='m'/><geom mesh='m' "
        "shellinertia='true'/></worldbody>");
  });
}

TEST_F(SceneOlder, TheMainClassHasOneName) {
  const Upgraded result = upgraded(
      "<default class='mine'><geom size='2'/></default><worldbody><body><geom/></body><geom "
      "class='mine'/></worldbody>");
  EXPECT_EQ(said(result.root().child("default"), "class"), "");
  EXPECT_EQ(said(result.root().select_node("/mujoco/default/default").node(), "class"), "mine");
  EXPECT_EQ(said(result.root().select_node("//body").node(), "childclass"), "mine");
}

TEST_F(SceneOlder, RefusesRemovedElementsWithTheirPlace) {
  const auto refused = [](const std::string& xml, const std::string& what) {
    expect_error(Status::kModel, what, [&] { upgraded(xml); });
  };
  refused("<equality><distance geom1='a' geom2='b'/></equality>", "does not know <distance> in <equality>");
  const auto composite = [](const std::string& attributes, const std::string& inside = "") {
    return "<worldbody><body name='B0'><composite " + attributes + ">" + inside + "</composite></body></worldbody>";
  };
  refused(composite("type='cable' count='9 1 1' spacing='.1'"), "does not know <composite> of type \"cable\"");
  refused(composite("type='rope' count='9 1 1' spacing='.1' curve='s'"), "the attribute curve of <composite> (\"s\")");
  refused(composite("type='rope' count='0 1 1' spacing='.1'"), "count is \"0 1 1\"");
  refused(composite("type='rope' count='1 3 1' spacing='.1'"), "with all ones at the end");
  refused(composite("type='rope' count='3' spacing='-1'"), "spacing is \"-1\", expected a length");
  refused(composite("type='rope' count='3 3 1' spacing='.1'"), "expected one dimension");
  refused(composite("type='rope' count='3 1 1' prefix='r' spacing='.1'"),
          "the body around it is \"B0\", expected \"rB\"");
  refused(composite("type='cloth' count='3 3 1' spacing='.1'"), "expected \"B\" and X_Y");
  refused(composite("type='box' count='3 3 1' spacing='.1'"), "expected three dimensions");
  refused(composite("type='grid' count='3 1 1' spacing='.1'", "<tendon kind='shear'/>"), "need two dimensions");
  refused(composite("type='grid' count='3 2 1' spacing='.1'", "<skin subgrid='2'/>"), "3 by 3 elements");
  refused(composite("type='rope' count='3 1 1' spacing='.1'", "<geom type='box' size='1 1 1'/>"),
          "type of its geom is");
  refused(composite("type='rope' count='300 1 1' spacing='.1' solrefsmooth='1 2 3'"), "at most 2 numbers");
  refused(composite("type='particle' count='100 100 100' spacing='.1'"), "more than max_elements");
}

#if MIMO_MUJOCO_4

TEST_F(SceneOlder, UpgradesDocumentsWhenLoading) {
  std::vector<std::string> warnings;
  scene::Source source = from_text(
      "<mujoco>\n<option apirate='50'>\n<flag passive='disable'/></option><worldbody><body name='B0'><composite "
      "type='rope' count='5 1 1' spacing='.1'><geom size='.02'/></composite></body></worldbody></mujoco>");
  source.log = LogSink([&](const LogRecord& record) { warnings.push_back(record.text); });
  const engine::ModelPtr model = compile(scene::Scene(source));
  EXPECT_EQ(model->nv, 8);
  EXPECT_EQ(model->opt.disableflags & (mjDSBL_SPRING | mjDSBL_DAMPER), mjDSBL_SPRING | mjDSBL_DAMPER);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(
      warnings[0],
      "xml text, line 2: MuJoCo 4.0.1 does not know the attribute apirate of <option>; it is left out, as it never "
      "did anything");
}

#endif

}  // namespace
}  // namespace mimo::test
