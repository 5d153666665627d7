// An infant lies where it has fallen: what touches what, with which force, and a picture with every contact marked.
//
//   c++ contacts.cpp $(pkg-config --cflags --libs mimo) && ./a.out contacts.ppm
#include <cstdio>
#include <fstream>
#include <mimo/mimo.hpp>

namespace {

mimo::Env make_world() {
  mimo_scene_config config = mimo::scene_config();
  config.name = "free";
  mimo::Scene scene(config);
  mimo_agent_config infant = scene.default_agent();
  infant.vision = infant.touch = 0;
  scene.add_agent(infant);
  return mimo::Env(scene);
}

// PPM is a format of pictures that needs no library.
void write(const mimo::Picture<mimo::Rgb>& picture, const char* path) {
  std::ofstream file(path, std::ios::binary);
  file << "P6 " << picture.width << ' ' << picture.height << " 255\n";
  file.write(reinterpret_cast<const char*>(picture.pixels.data()),
             static_cast<std::streamsize>(sizeof(mimo::Rgb) * picture.pixels.size()));
}

// A square of three pixels a side, where it is in the picture.
void mark(mimo::Picture<mimo::Rgb>& picture, const mimo::Vector& pixel) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const double x = pixel[0] + dx, y = pixel[1] + dy;
      if (pixel[2] <= 0 || x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
      picture.pixels[static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x)] = {255, 0, 0};
    }
  }
}

}  // namespace

int main(int argc, char** argv) try {
  mimo::Env env = make_world();
  mimo::Block block = env.make_block();
  mimo::Results results = env.make_results();
  env.reset(1, block);
  for (int i = 0; i < 200; ++i) env.step({}, block, results);  // two seconds

  const std::vector<mimo::Contact> contacts = env.contacts();
  std::vector<mimo::Vector> places;
  for (const mimo::Contact& contact : contacts) {
    std::printf("%-16s %-16s %7.2f N\n", env.name(MIMO_BODY, contact.bodies[0]).c_str(),
                env.name(MIMO_BODY, contact.bodies[1]).c_str(), contact.force[0]);
    places.push_back(contact.position);
  }

  mimo_picture_config view = mimo::picture_config();
  view.look_at[2] = 0.1;
  view.distance = 1.2;
  view.azimuth = 130;
  view.elevation = -25;
  mimo::Pictures seen = env.render(view);
  for (const mimo::Vector& pixel : env.project(view, places)) mark(seen.color, pixel);
  write(seen.color, argc > 1 ? argv[1] : "contacts.ppm");
  return 0;
} catch (const mimo::Exception& error) {
  std::fprintf(stderr, "%s: %s\n", mimo_status_name(error.status()), error.what());
  return 1;
}
