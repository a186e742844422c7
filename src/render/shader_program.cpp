// Compiling and linking shader programs.
#include "render/shader_program.h"

#include <array>
#include <string>

#include "weft/error.h"

namespace weft {

namespace {

/// The part of a shader that its program needs while it is linked.
class Shader {
public:
    Shader(GLenum kind, std::string_view common, std::string_view text)
        : name_(glCreateShader(kind)) {
        constexpr std::string_view version = "#version 330 core\n";
        const std::array<const GLchar*, 3> parts{version.data(), common.data(), text.data()};
        const std::array<GLint, 3> lengths{static_cast<GLint>(version.size()),
                                           static_cast<GLint>(common.size()),
                                           static_cast<GLint>(text.size())};
        glShaderSource(name_, 3, parts.data(), lengths.data());
        glCompileShader(name_);
    }
    ~Shader() { glDeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    [[nodiscard]] GLuint name() const { return name_; }

    void check() const {
        GLint compiled = GL_FALSE;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        std::array<GLchar, 2048> log{};
        glGetShaderInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error(ErrorKind::file, {}, "the OpenGL driver refuses a shader", log.data());
    }

private:
    GLuint name_;
};

void check_linked(GLuint program) {
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    std::array<GLchar, 2048> log{};
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw Error(ErrorKind::file, {}, "the OpenGL driver refuses a shader program", log.data());
}

void connect_inputs(GLuint program) {
    const GLuint block = glGetUniformBlockIndex(program, "Scene");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, scene_block_binding);
    glUseProgram(program);
    // A location of -1 (the shader does not read that texture) is ignored by OpenGL.
    glUniform1i(glGetUniformLocation(program, "cloth_texture"), cloth_texture_unit);
    glUniform1i(glGetUniformLocation(program, "shadow_map"), shadow_texture_unit);
    glUniform1i(glGetUniformLocation(program, "ends"), line_texture_unit);
    glUseProgram(0);
}

}  // namespace

GlProgram make_program(std::string_view common, std::string_view vertex,
                       std::string_view fragment) {
    const Shader vertex_shader(GL_VERTEX_SHADER, common, vertex);
    const Shader fragment_shader(GL_FRAGMENT_SHADER, common, fragment);
    vertex_shader.check();
    fragment_shader.check();
    GlProgram program;
    for (const Shader* shader : {&vertex_shader, &fragment_shader})
        glAttachShader(program.name(), shader->name());
    glLinkProgram(program.name());
    for (const Shader* shader : {&vertex_shader, &fragment_shader})
        glDetachShader(program.name(), shader->name());
    check_linked(program.name());
    connect_inputs(program.name());
    return program;
}

}  // namespace weft
