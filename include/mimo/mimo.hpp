/**
 * @file mimo/mimo.hpp
 * libmimo for C++11 and later: handles that free themselves, exceptions, typed views. No logic of its own.
 * MIT licence, see LICENSE.
 *
 *     mimo::Env env = mimo::make("benchmark");
 *     mimo::Block block = env.make_block();
 *     env.reset(42, block);
 *     env.step(actions, block);
 *     mimo::View<const float> angles = block.view<float>(env.layout().field("proprioception/position"));
 *
 * Everything that mimo.h says holds here; its functions take env.get(). A failed call throws mimo::Exception.
 * This is the one header to include; its chapters lie in mimo/hpp.
 * Its names are in an inline namespace of the minor version, so parts of a program may be compiled with different ones.
 * It includes mimo.h and experimental.h; methods that call experimental functions are experimental, too.
 */
#ifndef MIMO_HPP
#define MIMO_HPP

#include "experimental.h"
#include "hpp/batch.hpp"
#include "hpp/configs.hpp"
#include "hpp/conversions.hpp"
#include "hpp/env.hpp"
#include "hpp/geometry.hpp"
#include "hpp/handles.hpp"
#include "hpp/layout.hpp"
#include "hpp/observation.hpp"
#include "hpp/recording.hpp"
#include "hpp/results.hpp"
#include "hpp/scene.hpp"
#include "hpp/sense.hpp"
#include "hpp/senses.hpp"
#include "hpp/stage.hpp"
#include "hpp/task.hpp"

/// libmimo for C++, see mimo.hpp.
namespace mimo {}

#endif
