// What MIMo's left eye sees, as a PNG file. Uses libpng for the file.
//
//   c++ eye_picture.cpp $(pkg-config --cflags --libs mimo libpng) && ./a.out eye.png
#include <png.h>

#include <cstdio>
#include <mimo/mimo.hpp>

static void write_png(const char* path, const mimo::View<const std::uint8_t>& rgb, std::size_t height,
                      std::size_t width) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path, 0, rgb.data(), 0, nullptr)) throw std::runtime_error(image.message);
}

int main(int argc, char** argv) try {
  const char* path = argc > 1 ? argv[1] : "eye.png";
  mimo::Env env = mimo::make("benchmark");
  mimo::Block block = env.make_block();
  env.reset(42, block);

  const mimo_field eye = env.layout().field("vision/eye_left");
  write_png(path, block.view<std::uint8_t>(eye), eye.shape[0], eye.shape[1]);
  std::printf("%s: %zu x %zu pixels\n", path, eye.shape[1], eye.shape[0]);
  return 0;
} catch (const mimo::Exception& error) {
  if (error.status() == MIMO_E_UNSUPPORTED) return 77;  // nothing on this machine can draw
  std::fprintf(stderr, "%s: %s\n", mimo_status_name(error.status()), error.what());
  return 1;
}
