#pragma once

#include <functional>
#include <memory>

#include "app/viewer/picture/viewer_picture.hpp"

namespace taut::app {

/// An OpenGL context with the viewer's objects in it. It can be renewed after the driver has lost the
/// context.
class ViewerContext {
 public:
  using MakeContext = std::function<std::unique_ptr<renderer::Context>()>;

  /// Makes the first context. Throws renderer::ContextError.
  explicit ViewerContext(MakeContext make_context);
  ~ViewerContext();

  renderer::Context& context() { return *context_; }
  ViewerPicture& picture() { return *picture_; }

  /// Replaces the context and makes all objects again. References to the old ones become invalid. Throws
  /// renderer::ContextError.
  void renew();

 private:
  MakeContext make_context_;
  std::unique_ptr<renderer::Context> context_;
  std::unique_ptr<ViewerPicture> picture_;
};

}  // namespace taut::app
