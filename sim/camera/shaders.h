#pragma once

#include <string_view>

namespace eod::sim {

/// GLSL 3.30 sources, without the #version line. Colours are worked on linearly; textures and the
/// picture hold their square root.
extern const std::string_view kSurfaceVertexShader;
/// With GROUND defined: texture by position in the module, under slow variation, so that no tile
/// is seen. SPOTS: number of spot lights; WET: strength of the sheen of what is wet; INFRARED:
/// grey.
extern const std::string_view kSurfaceFragmentShader;
extern const std::string_view kShadowVertexShader;
extern const std::string_view kShadowFragmentShader;
extern const std::string_view kSkyVertexShader;
extern const std::string_view kSkyFragmentShader;
extern const std::string_view kOverlayVertexShader;
extern const std::string_view kOverlayFragmentShader;
/// Premultiplied colours, to be blended by (1, 1 - alpha), as are those of the effects.
extern const std::string_view kPlumeVertexShader;
extern const std::string_view kPlumeFragmentShader;
/// Three corners out of nothing, which cover the picture.
extern const std::string_view kEffectsVertexShader;
extern const std::string_view kEffectsFragmentShader;

}  // namespace eod::sim
