// Drags files onto a window and drops them there, as a file manager does (XDND, version 5).
//   drop_file TITLE FILE...
// TITLE is the beginning of the window's name. Fails if there is no such window, if the window refuses files, or if
// it does not confirm them in time.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::string file_uri(const std::string& file) {
  std::string uri = "file://";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("/-_.~", c) != nullptr) {
      uri += c;
    } else {
      char escaped[4];
      std::snprintf(escaped, sizeof escaped, "%%%02X", static_cast<unsigned char>(c));
      uri += escaped;
    }
  }
  return uri;
}

class Drag {
 public:
  Drag(const std::string& title, const std::vector<std::string>& files) {
    display_ = XOpenDisplay(nullptr);
    if (display_ == nullptr) {
      throw std::runtime_error("there is no display");
    }
    for (const std::string& file : files) {
      uris_ += file_uri(file) + "\r\n";
    }
    source_ = XCreateSimpleWindow(display_, root(), 0, 0, 1, 1, 0, 0, 0);
    target_ = window_titled(root(), title);
    if (target_ == None) {
      throw std::runtime_error("there is no window '" + title + "'");
    }
    XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
  }
  ~Drag() {
    if (display_ != nullptr) {
      XCloseDisplay(display_);
    }
  }

  void drop() {
    send("XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, (100L << 16) + 100, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    if ((answer("XdndStatus").data.l[1] & 1) == 0) {
      throw std::runtime_error("the window takes no files");
    }
    send("XdndDrop", 0, CurrentTime, 0, 0);
    // The lowest bit alone confirms it, but GLFW 3.3 answers with the number of bytes it was handed.
    if (answer("XdndFinished").data.l[1] == 0) {
      throw std::runtime_error("the window has not taken the files");
    }
  }

 private:
  Window root() { return DefaultRootWindow(display_); }
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  Window window_titled(Window parent, const std::string& title) {
    Window unused = None;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display_, parent, &unused, &unused, &children, &count);
    Window found = None;
    for (unsigned i = 0; i < count && found == None; ++i) {
      char* name = nullptr;
      if (XFetchName(display_, children[i], &name) != 0 && name != nullptr) {
        found = std::string(name).rfind(title, 0) == 0 ? children[i] : None;
        XFree(name);
      }
      found = found == None ? window_titled(children[i], title) : found;
    }
    XFree(children);
    return found;
  }

  void send(const char* kind, long one, long two, long three, long four) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.display = display_;
    event.xclient.window = target_;
    event.xclient.message_type = atom(kind);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(source_);
    event.xclient.data.l[1] = one;
    event.xclient.data.l[2] = two;
    event.xclient.data.l[3] = three;
    event.xclient.data.l[4] = four;
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  // Waits for an answer of this kind. Meanwhile it hands over the files' names at every request.
  XClientMessageEvent answer(const char* kind) {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(20)) {
      if (XPending(display_) == 0) {
        ::usleep(5000);
        continue;
      }
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == SelectionRequest) {
        hand_over(event.xselectionrequest);
      } else if (event.type == ClientMessage && event.xclient.message_type == atom(kind)) {
        return event.xclient;
      }
    }
    throw std::runtime_error(std::string("the window never answered with ") + kind);
  }

  void hand_over(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(uris_.data()), static_cast<int>(uris_.size()));
    XEvent reply{};
    reply.xselection.type = SelectionNotify;
    reply.xselection.requestor = request.requestor;
    reply.xselection.selection = request.selection;
    reply.xselection.target = request.target;
    reply.xselection.property = request.property;
    reply.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &reply);
    XFlush(display_);
  }

  Display* display_ = nullptr;
  Window source_ = None;
  Window target_ = None;
  std::string uris_;
};

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 3) {
    std::fputs("usage: drop_file TITLE FILE...\n", stderr);
    return 2;
  }
  try {
    Drag(arguments[1], {arguments + 2, arguments + argument_count}).drop();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "drop_file: %s\n", error.what());
    return 1;
  }
  return 0;
}
