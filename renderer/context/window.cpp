#include "renderer/context/window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glad/gl.h>

namespace taut::renderer {
namespace {

[[noreturn]] void fail(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw ContextError(what + (reason != nullptr ? std::string(": ") + reason : ""));
}

struct Library {
  Library() {
    if (glfwInit() == GLFW_FALSE) fail("no display for a window");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

class GlfwWindow final : public Window {
 public:
  explicit GlfwWindow(const WindowSettings& settings) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    handle_ = glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr, nullptr);
    if (handle_ == nullptr) fail("no window with OpenGL 3.3");
    try {
      make_current();
      load(glfwGetProcAddress);
    } catch (...) {
      glfwDestroyWindow(handle_);
      throw;
    }
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(handle_, this);
    watch();
  }

  ~GlfwWindow() override { glfwDestroyWindow(handle_); }

  void make_current() override {
    glfwMakeContextCurrent(handle_);
    if (glfwGetCurrentContext() != handle_) fail("the window's context cannot be used");
  }

  Resized framebuffer_size() const override {
    Resized size;
    glfwGetFramebufferSize(handle_, &size.width_px, &size.height_px);
    return size;
  }

  double content_scale() const override {
    float x = 1.0F, y = 1.0F;
    glfwGetWindowContentScale(handle_, &x, &y);
    return std::max(x, y);
  }

  std::vector<WindowEvent> wait_events(double timeout_s) override {
    if (timeout_s > 0.0) {
      glfwWaitEventsTimeout(timeout_s);
    } else {
      glfwPollEvents();
    }
    return std::exchange(events_, {});
  }

  void present() override { glfwSwapBuffers(handle_); }
  bool take_damage() override { return std::exchange(is_damaged_, false); }
  bool is_asked_to_close() const override { return glfwWindowShouldClose(handle_) == GLFW_TRUE; }
  void set_title(const std::string& title) override { glfwSetWindowTitle(handle_, title.c_str()); }

 private:
  static void note(GLFWwindow* window, WindowEvent event) {
    static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window))->events_.push_back(std::move(event));
  }

  // The display reports positions in its own units, which are not always pixels.
  static WindowEvent moved(GLFWwindow* window, double x, double y) {
    int width = 1, height = 1;
    glfwGetWindowSize(window, &width, &height);
    const Resized pixels = static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window))->framebuffer_size();
    return PointerMoved{x * pixels.width_px / std::max(width, 1), y * pixels.height_px / std::max(height, 1)};
  }

  void watch() {
    glfwSetKeyCallback(handle_, [](GLFWwindow* window, int key, int, int action, int) {
      const bool is_keypad_digit = key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9;
      const int named = is_keypad_digit ? key - GLFW_KEY_KP_0 + '0' : key;
      if (key != GLFW_KEY_UNKNOWN) note(window, KeyChanged{named, action != GLFW_RELEASE});
    });
    glfwSetCharCallback(handle_, [](GLFWwindow* window, unsigned character) { note(window, TextTyped{character}); });
    glfwSetCursorPosCallback(handle_,
                             [](GLFWwindow* window, double x, double y) { note(window, moved(window, x, y)); });
    glfwSetMouseButtonCallback(handle_, [](GLFWwindow* window, int button, int action, int) {
      if (button <= GLFW_MOUSE_BUTTON_MIDDLE) {
        note(window, ButtonChanged{static_cast<PointerButton>(button), action == GLFW_PRESS});
      }
    });
    glfwSetScrollCallback(handle_, [](GLFWwindow* window, double x, double y) { note(window, WheelTurned{x, y}); });
    glfwSetDropCallback(handle_, [](GLFWwindow* window, int count, const char** paths) {
      for (int i = 0; i < count; ++i) note(window, FileDropped{paths[i]});
    });
    glfwSetFramebufferSizeCallback(handle_, [](GLFWwindow* window, int width, int height) {
      note(window, Resized{width, height});
    });
    glfwSetWindowRefreshCallback(handle_, [](GLFWwindow* window) {
      static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window))->is_damaged_ = true;
    });
    glfwSetWindowContentScaleCallback(
        handle_, [](GLFWwindow* window, float x, float y) { note(window, ScaleChanged{std::max(x, y)}); });
  }

  Library library_;
  GLFWwindow* handle_ = nullptr;
  std::vector<WindowEvent> events_;
  bool is_damaged_ = false;
};

}  // namespace

std::unique_ptr<Window> open_window(const WindowSettings& settings) { return std::make_unique<GlfwWindow>(settings); }

}  // namespace taut::renderer
