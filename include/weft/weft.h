// All of weft's public interface.
#pragma once

#include "weft/error.h"
#include "weft/frame.h"
#include "weft/instruction_set.h"
#include "weft/integrators.h"
#include "weft/measures.h"
#include "weft/recorder.h"
#include "weft/scene.h"
#include "weft/simulation.h"
#include "weft/vec3.h"
#include "weft/version.h"
