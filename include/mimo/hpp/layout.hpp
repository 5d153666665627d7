/**
 * @file mimo/hpp/layout.hpp
 * What observations, actions and rewards consist of. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_LAYOUT
#define MIMO_HPP_LAYOUT

#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "configs.hpp"
#include "observation.hpp"
#include "results.hpp"

namespace mimo {
inline namespace v1_0 {

/// What a world, a batch or attached senses observe, act with and are rewarded for. It belongs to them, as do the
/// strings of what it describes.
class Layout {
 public:
  explicit Layout(const mimo_layout *layout) : layout_(layout) {}
  const mimo_layout *get() const { return layout_; }

  /// The sizes of everything.
  mimo_layout_info info() const {
    mimo_layout_info info = detail::described<mimo_layout_info>();
    check(mimo_layout_describe(layout_, &info));
    return info;
  }
  Block make_block() const { return Block(info().block_bytes); }

  std::vector<mimo_field> fields() const { return list(info().fields, mimo_layout_field); }
  std::vector<mimo_action> actions() const { return list(info().actions, mimo_layout_action); }
  /// Those of all agents, as results have them.
  std::vector<mimo_term> terms() const { return list(info().terms, mimo_layout_term); }

  /// Index of the field of that name.
  std::size_t find(const std::string &name) const {
    std::size_t index = 0;
    check(mimo_layout_find(layout_, name.c_str(), &index));
    return index;
  }
  mimo_field field(const std::string &name) const { return one(find(name), mimo_layout_field); }
  /// What one element of the flattened field is; "" in pictures and touch.
  std::string label(const std::string &field, std::size_t element) const {
    const char *label = nullptr;
    check(mimo_layout_label(layout_, find(field), element, &label));
    return label;
  }
  /// How late each element of the flattened field comes, in seconds; 0 for what is sensed at once.
  std::vector<double> delays(const std::string &name) const {
    const mimo_field it = field(name);
    const std::size_t elements =
        std::accumulate(it.shape, it.shape + it.ndim, std::size_t{1}, std::multiplies<std::size_t>());
    std::vector<double> seconds(elements);
    check(mimo_layout_delays(layout_, find(name), seconds.data(), seconds.size()));
    return seconds;
  }
  /// Where the pixels of a picture lie: unit vectors, height x width x 3, right, up, backwards.
  std::vector<float> directions(const std::string &name) const {
    const mimo_field picture = field(name);
    std::vector<float> directions(picture.ndim < 2 ? 0 : picture.shape[0] * picture.shape[1] * 3);
    check(mimo_layout_directions(layout_, find(name), directions.data(), directions.size()));
    return directions;
  }

  /// Where a field reports, in the order of its first axis; none where it is not of skin.
  std::vector<Receptor> receptors(const std::string &field) const {
    const std::size_t index = find(field);
    const std::vector<double> bodies = receptor_values(index, MIMO_RECEPTOR_BODY),
                              geoms = receptor_values(index, MIMO_RECEPTOR_GEOM),
                              positions = receptor_values(index, MIMO_RECEPTOR_POSITION),
                              frames = receptor_values(index, MIMO_RECEPTOR_FRAME);
    std::vector<Receptor> all(bodies.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].body = static_cast<std::int32_t>(bodies[i]);
      all[i].geom = static_cast<std::int32_t>(geoms[i]);
      all[i].position = detail::vector_of(positions, i);
      all[i].normal = detail::vector_of(frames, 3 * i);
      all[i].tangents[0] = detail::vector_of(frames, 3 * i + 1);
      all[i].tangents[1] = detail::vector_of(frames, 3 * i + 2);
    }
    return all;
  }
  /// A MIMO_RECEPTOR_ quantity of all of them, one after the other.
  std::vector<double> receptor_values(std::size_t field, mimo_quantity quantity) const {
    std::size_t count = 0;
    check(mimo_layout_receptor_width(layout_, field, quantity, &count));
    std::vector<double> values(count);
    check(mimo_layout_receptors(layout_, field, quantity, values.data(), values.size()));
    return values;
  }

 private:
  template <typename Part>
  using Describe = mimo_status (*)(const mimo_layout *, std::size_t, Part *);

  template <typename Part>
  Part one(std::size_t index, Describe<Part> describe) const {
    Part part = detail::described<Part>();
    check(describe(layout_, index, &part));
    return part;
  }
  template <typename Part>
  std::vector<Part> list(std::size_t count, Describe<Part> describe) const {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < count; ++i) parts.push_back(one(i, describe));
    return parts;
  }

  const mimo_layout *layout_;
};

namespace detail {
/// That of a handle.
template <typename T>
Layout layout_of(const T *handle, mimo_status (*get)(const T *, const mimo_layout **)) {
  const mimo_layout *layout = nullptr;
  check(get(handle, &layout));
  return Layout(layout);
}
}  // namespace detail

}  // namespace v1_0
}  // namespace mimo

#endif
