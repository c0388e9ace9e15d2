#include "places.hpp"

namespace course {

const Places& places() {
    static const Places known{TIMESTEP_SOURCE, TIMESTEP_BUILD, TIMESTEP_CMAKE, TIMESTEP_CTEST};
    return known;
}

}  // namespace course
