// wend.arena: disc robots in the plane.  The component is arena::World (world.hpp); its scenes are in scenes/, the
// geometry of what stands still in geometry/, robots' and movers' motion in motion/.
#include "world.hpp"

WEND_PLUGIN(wend::component<arena::World>("wend.arena"))
