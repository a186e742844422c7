// The shadow map and its view.
#include "render/shadow_map.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "render/shader_program.h"

namespace weft {

ShadowMap::ShadowMap(int resolution) : resolution_(resolution) {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, resolution, resolution, 0,
                 GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr std::array<float, 4> beyond{1.0F, 1.0F, 1.0F, 1.0F};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, beyond.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void ShadowMap::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, resolution_, resolution_);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::bind_texture() const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(shadow_texture_unit));
    glBindTexture(GL_TEXTURE_2D, texture_.name());
}

ShadowView sun_view(const Box& casters, glm::vec3 to_sun, std::optional<float> ground,
                    int resolution) {
    const glm::vec3 up = to_sun.y > 0.99F ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    const glm::mat4 turn = glm::lookAt(glm::vec3(0.0F), -to_sun, up);
    Box box;
    bool empty = true;
    for (const glm::vec3& corner : casters.corners()) {
        const glm::vec3 seen = turn * glm::vec4(corner, 1.0F);
        box = empty ? Box{seen, seen} : box.grown_to(seen);
        empty = false;
    }
    if (ground) {  // where the rays through the corners meet the ground
        for (const glm::vec3& corner : casters.corners()) {
            const float way = (corner.y - *ground) / to_sun.y;
            const float depth = (turn * glm::vec4(corner - way * to_sun, 1.0F)).z;
            box.low.z = std::min(box.low.z, depth);
        }
    }
    // A square map, with a margin for the soft edge and, in depth, for rounding.
    const glm::vec3 middle = box.middle();
    const float half = 0.52F * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const float slack = 0.02F * (box.high.z - box.low.z + half);
    const glm::mat4 flatten = glm::ortho(middle.x - half, middle.x + half, middle.y - half,
                                         middle.y + half, -box.high.z - slack, -box.low.z + slack);
    const glm::mat4 to_unit =
        glm::scale(glm::translate(glm::mat4(1.0F), glm::vec3(0.5F)), glm::vec3(0.5F));
    return {to_unit * flatten * turn, 2.0F * half / static_cast<float>(resolution)};
}

}  // namespace weft
