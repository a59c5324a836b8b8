#pragma once
// OpenGL ES objects with owners: programs, buffers, textures, framebuffers. All need a current context.
// Row 0 of every texture is its top row, so v = 0 is the top both for uploads and for what was drawn into it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/silhouette/image.hpp"
#include "ui/gl/context.hpp"

namespace ui {

/// A GL name that is 0 once moved from.
class GlName {
  public:
    GlName() = default;
    explicit GlName(unsigned name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    [[nodiscard]] unsigned get() const { return name_; }

  private:
    unsigned name_ = 0;
};

/// A linked pair of shaders. Whoever loads the same one in the same context shares it, for building it takes a tenth of
/// a second in software; so a uniform is what it was set to last by any of them: set all of them before drawing.
class Program {
  public:
    /// Builds `name`.vert and `name`.frag of ui/shaders. ErrorCode::Internal with the compiler's message.
    [[nodiscard]] static core::Result<Program> load(std::string_view name);

    void use() const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float x) const;
    void set(const char* uniform, float x, float y) const;
    void set(const char* uniform, float x, float y, float z) const;
    void set(const char* uniform, float x, float y, float z, float w) const;

  private:
    class Linked;
    explicit Program(std::shared_ptr<const Linked> linked) : linked_(std::move(linked)) {}
    [[nodiscard]] int location(const char* uniform) const;
    std::shared_ptr<const Linked> linked_;
};

enum class PixelFormat { Coverage, Colour };  ///< one byte (R8), or four with premultiplied alpha (RGBA8)

/// Linear filtering, edges clamped.
class Texture {
  public:
    Texture(SizePx size, PixelFormat format);
    /// A picture of four bytes a pixel that repeats without end, with smaller ones of itself for where it is far away.
    [[nodiscard]] static Texture repeating(SizePx size, std::span<const std::uint8_t> rows);
    Texture(Texture&&) noexcept = default;
    Texture& operator=(Texture&&) noexcept = default;
    ~Texture();

    /// Replaces the rectangle with tightly packed rows, top first.
    void upload(int x, int y, SizePx size, std::span<const std::uint8_t> rows);
    void bind(int unit) const;
    [[nodiscard]] SizePx size() const { return size_; }
    [[nodiscard]] unsigned name() const { return name_.get(); }

  private:
    Texture(SizePx size, PixelFormat format, int levels);
    GlName name_;
    SizePx size_;
    PixelFormat format_;
};

/// A texture that can be drawn into; with samples > 0 and depth through a multisampled buffer that resolve() copies.
class Target {
  public:
    enum class Depth { None, Multisampled };
    Target(SizePx size, PixelFormat format, Depth depth = Depth::None);
    Target(Target&& other) noexcept = default;
    Target& operator=(Target&& other) noexcept = default;
    ~Target();

    /// Directs drawing here and sets the viewport to the whole of it.
    void bind() const;
    /// Makes texture() show what was drawn. Nothing to do without multisampling.
    void resolve() const { resolve(0, 0, size()); }
    /// Of this part of it alone.
    void resolve(int x, int y, SizePx part) const;
    [[nodiscard]] const Texture& texture() const { return texture_; }
    /// The texture as it is; an empty one of the same size takes its place, and the other buffers stay.
    [[nodiscard]] Texture take_texture();
    [[nodiscard]] SizePx size() const { return texture_.size(); }
    /// The pixels, top row first; a coverage target gives its value as red.
    [[nodiscard]] core::RgbaImage read_back() const;
    /// Copies the pixels as they lie to the window's frame, first row to first row, and leaves that bound.
    void copy_to_window() const;

  private:
    Texture texture_;
    PixelFormat format_;
    GlName frame_, sampled_frame_, sampled_colour_, sampled_depth_;
};

/// Directs drawing to the window (or whatever frame 0 is) and sets the viewport.
void bind_window(SizePx size);

/// Interleaved floats that change often, with the vertex array that reads them.
class VertexStream {
  public:
    /// `layout` lists the number of floats of attribute 0, 1, …; `per_instance` steps them once an instance.
    VertexStream(std::initializer_list<int> layout, bool per_instance);
    VertexStream(VertexStream&&) noexcept = default;
    VertexStream& operator=(VertexStream&&) noexcept = default;
    ~VertexStream();

    void fill(std::span<const float> floats);
    /// Four corners a quad, one quad an instance.
    void draw_quads(int instances) const;
    void draw_triangles(int vertices) const { draw_triangles(0, vertices); }
    void draw_triangles(int first, int vertices) const;

  private:
    GlName array_, buffer_;
};

enum class Blend { Off, Over, Multiply, Maximum };  ///< Over expects premultiplied colours
void set_blend(Blend blend);
void set_depth_test(bool on);
void clear(float r, float g, float b, float a, bool depth = false);
/// Limits drawing and clearing to the rectangle, counted from the target's first row; without size: no limit.
void set_scissor(int x, int y, SizePx size);
/// Waits until all drawing is done; for measuring.
void finish();
/// What draws, as the driver names it.
[[nodiscard]] std::string renderer_name();

}  // namespace ui
