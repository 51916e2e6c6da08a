#include "app/viewer/viewer_context.hpp"

#include <utility>

namespace taut::app {

ViewerContext::ViewerContext(MakeContext make_context) : make_context_(std::move(make_context)) {
  renew();
}

ViewerContext::~ViewerContext() = default;

void ViewerContext::renew() {
  picture_.reset();
  // One at a time: a window system may have no second one to give.
  context_.reset();
  context_ = make_context_();
  picture_ = std::make_unique<ViewerPicture>(*context_);
}

}  // namespace taut::app
