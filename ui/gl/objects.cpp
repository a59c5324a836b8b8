#include "ui/gl/objects.hpp"

#include <EGL/egl.h>
#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "ui/gl/embedded.hpp"

namespace ui {
namespace {

core::Result<unsigned> compile(GLenum kind, const std::string& file) {
    for (const EmbeddedFile& f : shader_files()) {
        if (f.name != file) continue;
        const unsigned shader = glCreateShader(kind);
        const char* text = f.content.data();
        const GLint length = static_cast<GLint>(f.content.size());
        glShaderSource(shader, 1, &text, &length);
        glCompileShader(shader);
        GLint ok = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        if (ok != 0) return shader;
        std::array<char, 1000> log{};
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        glDeleteShader(shader);
        return core::unexpected(core::ErrorCode::Internal, std::string("the shader does not compile: ") + log.data(),
                                file);
    }
    return core::unexpected(core::ErrorCode::Internal, "the shader is not built in", file);
}

unsigned new_frame(unsigned texture) {
    unsigned frame = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    return frame;
}

unsigned new_sampled_buffer(GLenum format, SizePx size) {
    unsigned buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, format, size.width, size.height);
    return buffer;
}

}  // namespace

class Program::Linked {
  public:
    explicit Linked(unsigned name) : name_(name) {}
    Linked(const Linked&) = delete;
    Linked& operator=(const Linked&) = delete;
    ~Linked() { glDeleteProgram(name_); }
    [[nodiscard]] unsigned name() const { return name_; }

  private:
    unsigned name_;
};

core::Result<Program> Program::load(std::string_view name) {
    // those in use, by context; contexts are current in one thread
    static thread_local std::map<std::pair<void*, std::string>, std::weak_ptr<const Linked>> in_use;
    std::weak_ptr<const Linked>& known = in_use[{eglGetCurrentContext(), std::string(name)}];
    if (std::shared_ptr<const Linked> shared = known.lock()) return Program(std::move(shared));
    const core::Result<unsigned> vertex = compile(GL_VERTEX_SHADER, std::string(name) + ".vert");
    if (!vertex) return core::unexpected(vertex.error());
    const core::Result<unsigned> fragment = compile(GL_FRAGMENT_SHADER, std::string(name) + ".frag");
    if (!fragment) {
        glDeleteShader(*vertex);
        return core::unexpected(fragment.error());
    }
    const auto linked = std::make_shared<const Linked>(glCreateProgram());
    glAttachShader(linked->name(), *vertex);
    glAttachShader(linked->name(), *fragment);
    glLinkProgram(linked->name());
    glDeleteShader(*vertex);
    glDeleteShader(*fragment);
    GLint ok = 0;
    glGetProgramiv(linked->name(), GL_LINK_STATUS, &ok);
    if (ok != 0) {
        known = linked;
        return Program(linked);
    }
    std::array<char, 1000> log{};
    glGetProgramInfoLog(linked->name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    return core::unexpected(core::ErrorCode::Internal, std::string("the shaders do not link: ") + log.data(),
                            std::string(name));
}

void Program::use() const {
    glUseProgram(linked_->name());
}
int Program::location(const char* uniform) const {
    return glGetUniformLocation(linked_->name(), uniform);
}
void Program::set(const char* uniform, int value) const {
    glUniform1i(location(uniform), value);
}
void Program::set(const char* uniform, float x) const {
    glUniform1f(location(uniform), x);
}
void Program::set(const char* uniform, float x, float y) const {
    glUniform2f(location(uniform), x, y);
}
void Program::set(const char* uniform, float x, float y, float z) const {
    glUniform3f(location(uniform), x, y, z);
}
void Program::set(const char* uniform, float x, float y, float z, float w) const {
    glUniform4f(location(uniform), x, y, z, w);
}

Texture::Texture(SizePx size, PixelFormat format) : Texture(size, format, 1) {}

Texture Texture::repeating(SizePx size, std::span<const std::uint8_t> rows) {
    int levels = 1;
    while ((std::max(size.width, size.height) >> levels) > 0) ++levels;
    Texture texture(size, PixelFormat::Colour, levels);
    texture.upload(0, 0, size, rows);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    return texture;
}

Texture::Texture(SizePx size, PixelFormat format, int levels) : size_(size), format_(format) {
    unsigned name = 0;
    glGenTextures(1, &name);
    name_ = GlName(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, levels, format == PixelFormat::Coverage ? GL_R8 : GL_RGBA8, size.width, size.height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::~Texture() {
    const unsigned name = name_.get();
    if (name != 0) glDeleteTextures(1, &name);
}

void Texture::upload(int x, int y, SizePx size, std::span<const std::uint8_t> rows) {
    glBindTexture(GL_TEXTURE_2D, name_.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, size.width, size.height,
                    format_ == PixelFormat::Coverage ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glBindTexture(GL_TEXTURE_2D, name_.get());
    glActiveTexture(GL_TEXTURE0);
}

Target::Target(SizePx size, PixelFormat format, Depth depth) : texture_(size, format), format_(format) {
    frame_ = GlName(new_frame(texture_.name()));
    if (depth == Depth::None) return;
    sampled_colour_ = GlName(new_sampled_buffer(GL_RGBA8, size));
    sampled_depth_ = GlName(new_sampled_buffer(GL_DEPTH_COMPONENT24, size));
    unsigned frame = 0;
    glGenFramebuffers(1, &frame);
    sampled_frame_ = GlName(frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, sampled_colour_.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, sampled_depth_.get());
}

Target::~Target() {
    for (const GlName* frame : {&frame_, &sampled_frame_}) {
        const unsigned name = frame->get();
        if (name != 0) glDeleteFramebuffers(1, &name);
    }
    for (const GlName* buffer : {&sampled_colour_, &sampled_depth_}) {
        const unsigned name = buffer->get();
        if (name != 0) glDeleteRenderbuffers(1, &name);
    }
}

Texture Target::take_texture() {
    Texture taken = std::exchange(texture_, Texture(size(), format_));
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    return taken;
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, sampled_frame_.get() != 0 ? sampled_frame_.get() : frame_.get());
    glViewport(0, 0, size().width, size().height);
}

void Target::resolve(int x, int y, SizePx part) const {
    if (sampled_frame_.get() == 0) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_frame_.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_.get());
    const int right = x + part.width, bottom = y + part.height;
    glBlitFramebuffer(x, y, right, bottom, x, y, right, bottom, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

core::RgbaImage Target::read_back() const {
    resolve();
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.get());
    core::RgbaImage image;
    image.width = size().width;
    image.height = size().height;
    image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

void Target::copy_to_window() const {
    resolve();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size().width, size().height, 0, 0, size().width, size().height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    bind_window(size());
}

void bind_window(SizePx size) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
}

VertexStream::VertexStream(std::initializer_list<int> layout, bool per_instance) {
    unsigned array = 0, buffer = 0;
    glGenVertexArrays(1, &array);
    glGenBuffers(1, &buffer);
    array_ = GlName(array);
    buffer_ = GlName(buffer);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    int floats = 0;
    for (const int n : layout) floats += n;
    unsigned attribute = 0;
    std::size_t offset = 0;
    for (const int n : layout) {
        glEnableVertexAttribArray(attribute);
        // NOLINTNEXTLINE(performance-no-int-to-ptr): the interface takes an offset into the buffer as a pointer
        const auto* place = reinterpret_cast<const void*>(offset * sizeof(float));
        glVertexAttribPointer(attribute, n, GL_FLOAT, GL_FALSE, floats * static_cast<int>(sizeof(float)), place);
        if (per_instance) glVertexAttribDivisor(attribute, 1);
        offset += static_cast<std::size_t>(n);
        ++attribute;
    }
}

VertexStream::~VertexStream() {
    const unsigned array = array_.get(), buffer = buffer_.get();
    if (array != 0) glDeleteVertexArrays(1, &array);
    if (buffer != 0) glDeleteBuffers(1, &buffer);
}

void VertexStream::fill(std::span<const float> floats) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(floats.size_bytes()), floats.data(), GL_STREAM_DRAW);
}

void VertexStream::draw_quads(int instances) const {
    glBindVertexArray(array_.get());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
}

void VertexStream::draw_triangles(int first, int vertices) const {
    glBindVertexArray(array_.get());
    glDrawArrays(GL_TRIANGLES, first, vertices);
}

void set_blend(Blend blend) {
    if (blend == Blend::Off) {
        glDisable(GL_BLEND);
        return;
    }
    glEnable(GL_BLEND);
    glBlendEquation(blend == Blend::Maximum ? GL_MAX : GL_FUNC_ADD);
    if (blend == Blend::Multiply) {
        glBlendFunc(GL_DST_COLOR, GL_ZERO);
    } else {
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
}

void set_depth_test(bool on) {
    if (on) {
        glEnable(GL_DEPTH_TEST);
    } else {
        glDisable(GL_DEPTH_TEST);
    }
}

void clear(float r, float g, float b, float a, bool depth) {
    glClearColor(r, g, b, a);
    glClear(depth ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT);
}

void set_scissor(int x, int y, SizePx size) {
    if (size.width <= 0 || size.height <= 0) {
        glDisable(GL_SCISSOR_TEST);
        return;
    }
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, size.width, size.height);
}

void finish() {
    glFinish();
}

std::string renderer_name() {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name != nullptr ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace ui
