#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/format.h"
#include "document/composites.h"
#include "document/report.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

struct Bone {
  std::string body;
  std::array<double, 3> place{};
  std::vector<int> vertices;
  std::vector<double> weights;
};

// MuJoCo keeps all of this in single precision.
class Skin {
 public:
  int add_vertex(double x, double y, double u, double v) {
    for (const double value : {x, y, 0.0}) vertices_.push_back(value);
    for (const double value : {u, v}) texture_.push_back(value);
    return count_++;
  }
  void add_face(int a, int b, int c) {
    for (const int vertex : {a, b, c}) faces_.push_back(vertex);
  }
  Bone& add_bone(const std::string& body) {
    bones_.push_back({body, {}, {}, {}});
    return bones_.back();
  }
  void add_point_bone(const std::string& body, std::initializer_list<int> vertices) {
    Bone& bone = add_bone(body);
    bone.vertices = vertices;
    bone.weights.assign(bone.vertices.size(), 1);
  }
  Bone& bone(int number) { return bones_[static_cast<std::size_t>(number)]; }

  void write(const Composite& composite, pugi::xml_node assets) const {
    const pugi::xml_node skin = append(assets, "skin");
    set(skin, "name", composite.named("Skin", {}));
    set(skin, "rgba", "1 1 1 1");
    for (const pugi::xml_attribute said : composite.skin.attributes()) {
      const std::string name = said.name();
      if (name != "texcoord" && name != "subgrid") set(skin, said.name(), said.value());
    }
    set(skin, "vertex", join(vertices_, " "));
    set(skin, "face", join(faces_, " "));
    if (std::string(composite.skin.attribute("texcoord").value()) == "true") set(skin, "texcoord", join(texture_, " "));
    for (const Bone& entry : bones_) {
      const pugi::xml_node bone = append(skin, "bone");
      set(bone, "body", entry.body);
      set(bone, "bindpos", Span<const double>(entry.place));
      set(bone, "bindquat", "1 0 0 0");
      set(bone, "vertid", join(entry.vertices, " "));
      set(bone, "vertweight", join(entry.weights, " "));
    }
  }

 private:
  std::vector<double> vertices_, texture_;
  std::vector<int> faces_;
  std::vector<Bone> bones_;
  int count_ = 0;
};

double share(int at, int count) { return static_cast<float>(at) / static_cast<float>(count - 1); }

// Two triangles between four vertices of a grid whose rows are `width` apart, seen from one side or the other.
void add_square(Skin& skin, int corner, int width, bool other_side) {
  const int next = corner + width, one = other_side ? 1 : 0, two = 1 - one;
  skin.add_face(corner, next + one, next + two);
  skin.add_face(corner, corner + two * width + 1, corner + one * width + 1);
}

// Both sides of a sheet, and what closes it at its edges.
void add_sheet(Skin& skin, int rows, int width, double spacing) {
  const int all = rows * width;
  for (const bool back : {false, true}) {
    for (int x = 0; x < rows; ++x) {
      for (int y = 0; y < width; ++y) {
        const int vertex = skin.add_vertex(x * spacing, y * spacing, share(x, rows), share(y, width));
        if (x + 1 < rows && y + 1 < width) add_square(skin, vertex, width, back);
      }
    }
  }
  const auto edge = [&](int from, int to) {
    skin.add_face(from, all + to, to);
    skin.add_face(from, all + from, all + to);
  };
  const auto other_edge = [&](int from, int to) {
    skin.add_face(from, to, all + to);
    skin.add_face(from, all + to, all + from);
  };
  for (int x = 0; x + 1 < rows; ++x) edge(x * width, (x + 1) * width);
  for (int x = 0; x + 1 < rows; ++x) other_edge(x * width + width - 1, (x + 1) * width + width - 1);
  for (int y = 0; y + 1 < width; ++y) other_edge(y, y + 1);
  for (int y = 0; y + 1 < width; ++y) edge(y + (rows - 1) * width, y + 1 + (rows - 1) * width);
}

// How much the four bodies before, at the ends of, and behind a stretch count for a point of it: a cubic through its
// ends, whose slopes are those between the neighbours; at the border, that of the stretch.
std::array<double, 4> weights(double t, bool first, bool last) {
  const double start = 1 - 3 * t * t + 2 * t * t * t, end = 3 * t * t - 2 * t * t * t;
  const double slope_at_start = t - 2 * t * t + t * t * t, slope_at_end = t * t * t - t * t;
  std::array<double, 4> all{0, start, end, 0};
  const auto add_slope = [&](double slope, std::size_t from, std::size_t to, double length) {
    all[to] += slope / length;
    all[from] -= slope / length;
  };
  first ? add_slope(slope_at_start, 1, 2, 1) : add_slope(slope_at_start, 0, 2, 2);
  last ? add_slope(slope_at_end, 1, 2, 1) : add_slope(slope_at_end, 1, 3, 2);
  return all;
}

// Binds the finer vertices in one square between four bodies to the sixteen around it.
void bind_square(Skin& skin, const Composite& composite, int x, int y, int fineness, int rows, int width) {
  const int ends_x = composite.count[0] - 2, ends_y = composite.count[1] - 2;
  for (int i = 0; i < fineness + (x == ends_x ? 1 : 0); ++i) {
    for (int j = 0; j < fineness + (y == ends_y ? 1 : 0); ++j) {
      const int vertex = (x * fineness + i) * width + y * fineness + j;
      const auto along_x = weights(static_cast<double>(i) / fineness, x == 0, x == ends_x);
      const auto along_y = weights(static_cast<double>(j) / fineness, y == 0, y == ends_y);
      for (int k = 0; k < 16; ++k) {
        const double weight = along_x[static_cast<std::size_t>(k / 4)] * along_y[static_cast<std::size_t>(k % 4)];
        if (weight == 0) continue;
        Bone& bone = skin.bone((x + k / 4 - 1) * composite.count[1] + y + k % 4 - 1);
        for (const int side : {vertex, vertex + rows * width}) {
          bone.vertices.push_back(side);
          bone.weights.push_back(weight);
        }
      }
    }
  }
}

void add_fine_sheet(Skin& skin, const Composite& composite, int fineness) {
  if (composite.count[0] < 3 || composite.count[1] < 3) composite.refuse("a finer skin needs at least 3 by 3 elements");
  const int rows = (composite.count[0] - 1) * fineness + 1, width = (composite.count[1] - 1) * fineness + 1;
  add_sheet(skin, rows, width, composite.spacing / fineness);
  for (int x = 0; x < composite.count[0]; ++x) {
    for (int y = 0; y < composite.count[1]; ++y) {
      skin.add_bone(composite.named("B", {x, y})).place = {x * composite.spacing, y * composite.spacing, 0};
    }
  }
  for (int x = 0; x + 1 < composite.count[0]; ++x) {
    for (int y = 0; y + 1 < composite.count[1]; ++y) bind_square(skin, composite, x, y, fineness, rows, width);
  }
}

// A side of a solid: elements whose number along an axis is the first or the last.
struct Side {
  std::size_t axis;
  bool last, flipped;
};
constexpr std::array<Side, 6> kBoxSides = {
    {{2, false, true}, {2, true, false}, {1, false, false}, {1, true, true}, {0, false, true}, {0, true, false}}};

class Sides {
 public:
  explicit Sides(const Composite& composite) : composite_(composite) {}

  // A side with vertices of its own, so that its edges are sharp.
  void add_sharp(const Side& side) {
    const auto [rows, width] = size(side);
    int vertex = 0;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < width; ++j) {
        vertex = skin.add_vertex(0, 0, share(i, rows), share(j, width));
        if (i + 1 < rows && j + 1 < width) add_square(skin, vertex, width, side.flipped);
        skin.add_point_bone(body(side, i, j), {vertex});
      }
    }
  }

  // Vertices that sides share, so that edges are round: of elements that lie on one of the first axes' sides.
  void add_shared_vertices(std::size_t axes) {
    const auto& count = composite_.count;
    for (int x = 0; x < count[0]; ++x) {
      for (int y = 0; y < count[1]; ++y) {
        for (int z = 0; z < count[2]; ++z) {
          const std::array<int, 3> at{x, y, z};
          std::size_t axis = 0;
          while (axis < axes && at[axis] != 0 && at[axis] != count[axis] - 1) ++axis;
          if (axis == axes) continue;
          const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
          shared_[composite_.named("B", {x, y, z})] =
              skin.add_vertex(0, 0, share(at[u], count[u]), share(at[v], count[v]));
        }
      }
    }
  }

  void add_round(const Side& side) {
    const auto [rows, width] = size(side);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < width; ++j) {
        const int vertex = shared_.at(body(side, i, j));
        if (i + 1 < rows && j + 1 < width) {
          const int right = shared_.at(body(side, i + 1, j)), up = shared_.at(body(side, i, j + 1));
          const int both = shared_.at(body(side, i + 1, j + 1));
          skin.add_face(vertex, side.flipped ? up : right, both);
          skin.add_face(vertex, both, side.flipped ? right : up);
        }
        skin.add_point_bone(body(side, i, j), {vertex});
      }
    }
  }

  Skin skin;

 private:
  std::array<int, 2> size(const Side& side) const {
    return {composite_.count[side.axis == 0 ? 1 : 0], composite_.count[side.axis == 2 ? 1 : 2]};
  }

  std::string body(const Side& side, int i, int j) const {
    const int at = side.last ? composite_.count[side.axis] - 1 : 0;
    if (side.axis == 0) return composite_.named("B", {at, i, j});
    return side.axis == 1 ? composite_.named("B", {i, at, j}) : composite_.named("B", {i, j, at});
  }

  const Composite& composite_;
  std::map<std::string, int> shared_;
};

}  // namespace

void add_sheet_skin(const Composite& composite, pugi::xml_node assets) {
  if (composite.skin.empty()) return;
  double finer = 0;
  composite.read(composite.skin.attribute("subgrid"), Span<double>(&finer, 1));
  Skin skin;
  if (finer >= 1) {
    add_fine_sheet(skin, composite, static_cast<int>(finer) + 1);
  } else {
    add_sheet(skin, composite.count[0], composite.count[1], 0);
    for (int x = 0, vertex = 0; x < composite.count[0]; ++x) {
      for (int y = 0; y < composite.count[1]; ++y, ++vertex) {
        skin.add_point_bone(composite.named("B", {x, y}), {vertex, vertex + composite.count[0] * composite.count[1]});
      }
    }
  }
  skin.write(composite, assets);
}

void add_solid_skin(const Composite& composite, pugi::xml_node assets) {
  if (composite.skin.empty()) return;
  Sides sides(composite);
  if (composite.is({"box"})) {
    for (const Side& side : kBoxSides) sides.add_sharp(side);
  } else if (composite.is({"cylinder"})) {
    sides.add_shared_vertices(2);
    for (std::size_t i = 2; i < 6; ++i) sides.add_round(kBoxSides[i]);
    for (std::size_t i = 0; i < 2; ++i) sides.add_sharp(kBoxSides[i]);
  } else {
    sides.add_shared_vertices(3);
    for (const Side& side : kBoxSides) sides.add_round(side);
  }
  sides.skin.write(composite, assets);
}

}  // namespace mimo::document
