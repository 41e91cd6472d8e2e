// wend/plugin.hpp -- all that a plugin in C++ needs.
#pragma once
#include <wend/abi.h>
#include <wend/component.hpp>
#include <wend/config.hpp>
#include <wend/math.hpp>
#include <wend/random.hpp>
#include <wend/refs.hpp>
#include <wend/space.hpp>
#include <wend/view.hpp>
