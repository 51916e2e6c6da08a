#include "app/viewer/panel/user_interface.hpp"

#include <fontconfig/fontconfig.h>
#include <imgui.h>

namespace taut::app {
namespace {

namespace keys = renderer::keys;

constexpr double letter_height_px = 15.0;

static_assert(sizeof(ImDrawVert) == sizeof(renderer::OverlayVertex));
static_assert(offsetof(ImDrawVert, uv) == offsetof(renderer::OverlayVertex, sheet_place));
static_assert(offsetof(ImDrawVert, col) == offsetof(renderer::OverlayVertex, colour_rgba8));
static_assert(sizeof(ImDrawIdx) == sizeof(std::uint16_t));

constexpr std::array<std::pair<ImGuiKey, int>, 19> navigation_keys = {{
    {ImGuiKey_Tab, keys::tab},
    {ImGuiKey_LeftArrow, keys::left},
    {ImGuiKey_RightArrow, keys::right},
    {ImGuiKey_UpArrow, keys::up},
    {ImGuiKey_DownArrow, keys::down},
    {ImGuiKey_PageUp, keys::page_up},
    {ImGuiKey_PageDown, keys::page_down},
    {ImGuiKey_Home, keys::home},
    {ImGuiKey_End, keys::end},
    {ImGuiKey_Insert, keys::insert},
    {ImGuiKey_Delete, keys::del},
    {ImGuiKey_Backspace, keys::backspace},
    {ImGuiKey_Space, keys::space},
    {ImGuiKey_Enter, keys::enter},
    {ImGuiKey_Escape, keys::escape},
    {ImGuiKey_A, 'A'},
    {ImGuiKey_C, 'C'},
    {ImGuiKey_V, 'V'},
    {ImGuiKey_X, 'X'},
}};

// Returns the font file that the program uses for other text; empty if there is none.
std::filesystem::path font_file() {
  FcConfig* config = FcInitLoadConfigAndFonts();
  FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans"));
  FcConfigSubstitute(config, wanted, FcMatchPattern);
  FcDefaultSubstitute(wanted);
  FcResult result = FcResultNoMatch;
  FcPattern* match = FcFontMatch(config, wanted, &result);
  FcChar8* file = nullptr;
  std::filesystem::path path;
  if (match != nullptr && FcPatternGetString(match, FC_FILE, 0, &file) == FcResultMatch) {
    path = reinterpret_cast<const char*>(file);
  }
  if (match != nullptr) FcPatternDestroy(match);
  FcPatternDestroy(wanted);
  FcConfigDestroy(config);
  return path;
}

void set_colours(ImGuiStyle& style) {
  ImGui::StyleColorsLight(&style);
  const ImVec4 ink{0.13F, 0.15F, 0.18F, 1.0F};
  const ImVec4 accent{0.25F, 0.44F, 0.66F, 1.0F};
  const auto with_alpha = [](ImVec4 colour, float alpha) {
    colour.w = alpha;
    return colour;
  };
  style.Colors[ImGuiCol_Text] = ink;
  style.Colors[ImGuiCol_TextDisabled] = {0.42F, 0.45F, 0.50F, 1.0F};
  style.Colors[ImGuiCol_WindowBg] = {0.965F, 0.965F, 0.96F, 1.0F};
  style.Colors[ImGuiCol_PopupBg] = {1.0F, 1.0F, 1.0F, 1.0F};
  style.Colors[ImGuiCol_Border] = {0.0F, 0.0F, 0.0F, 0.14F};
  style.Colors[ImGuiCol_FrameBg] = {0.88F, 0.89F, 0.90F, 1.0F};
  style.Colors[ImGuiCol_FrameBgHovered] = {0.82F, 0.86F, 0.90F, 1.0F};
  style.Colors[ImGuiCol_FrameBgActive] = {0.76F, 0.82F, 0.89F, 1.0F};
  style.Colors[ImGuiCol_SliderGrab] = with_alpha(accent, 0.4F);
  style.Colors[ImGuiCol_SliderGrabActive] = accent;
  style.Colors[ImGuiCol_CheckMark] = accent;
  style.Colors[ImGuiCol_Button] = {0.86F, 0.88F, 0.90F, 1.0F};
  style.Colors[ImGuiCol_ButtonHovered] = with_alpha(accent, 0.35F);
  style.Colors[ImGuiCol_ButtonActive] = with_alpha(accent, 0.6F);
  style.Colors[ImGuiCol_Header] = with_alpha(accent, 0.22F);
  style.Colors[ImGuiCol_HeaderHovered] = with_alpha(accent, 0.32F);
  style.Colors[ImGuiCol_HeaderActive] = with_alpha(accent, 0.45F);
  style.Colors[ImGuiCol_Separator] = {0.0F, 0.0F, 0.0F, 0.12F};
}

struct Feeder {
  ImGuiIO& io;

  void operator()(const renderer::KeyChanged& event) const {
    if (event.key < 0 || event.key > keys::last) return;
    io.KeysDown[event.key] = event.down;
    io.KeyCtrl = io.KeysDown[keys::left_control] || io.KeysDown[keys::right_control];
    io.KeyShift = io.KeysDown[keys::left_shift] || io.KeysDown[keys::right_shift];
    io.KeyAlt = io.KeysDown[keys::left_alt] || io.KeysDown[keys::right_alt];
  }
  void operator()(const renderer::TextTyped& event) const {
    io.AddInputCharacter(static_cast<unsigned>(event.character));
  }
  void operator()(const renderer::PointerMoved& event) const {
    io.MousePos = {static_cast<float>(event.x_px), static_cast<float>(event.y_px)};
  }
  void operator()(const renderer::ButtonChanged& event) const {
    io.MouseDown[static_cast<std::size_t>(event.button)] = event.down;
  }
  void operator()(const renderer::WheelTurned& event) const {
    io.MouseWheel += static_cast<float>(event.y);
    io.MouseWheelH += static_cast<float>(event.x);
  }
  void operator()(const auto&) const {}
};

}  // namespace

UserInterface::UserInterface(double scale) : context_(ImGui::CreateContext()), scale_(scale), font_(font_file()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  for (const auto& [navigation, key] : navigation_keys) io.KeyMap[navigation] = key;
  io.MousePos = {-1.0F, -1.0F};
  make_letters();
}

UserInterface::~UserInterface() { ImGui::DestroyContext(context_); }

void UserInterface::set_scale(double scale) {
  if (scale != scale_) {
    scale_ = scale;
    make_letters();
  }
}

void UserInterface::make_letters() {
  const auto scale = static_cast<float>(scale_);
  ImGuiStyle style;
  set_colours(style);
  style.WindowRounding = 0.0F;
  style.FrameRounding = 3.0F;
  style.GrabRounding = 3.0F;
  style.GrabMinSize = 8.0F;
  style.WindowBorderSize = 0.0F;
  style.ItemSpacing = {6.0F, 2.0F};
  style.FramePadding = {6.0F, 3.0F};
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;

  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  // Latin letters, dashes, arrows and simple symbols.
  static constexpr std::array<ImWchar, 9> ranges = {0x20, 0xFF, 0x2010, 0x2027, 0x2190, 0x2199, 0x2212, 0x2212, 0};
  const float height_px = static_cast<float>(letter_height_px) * scale;
  const bool has_font = !font_.empty() && std::filesystem::exists(font_) &&
                        atlas.AddFontFromFileTTF(font_.c_str(), height_px, nullptr, ranges.data()) != nullptr;
  if (!has_font) {
    ImFontConfig plain;
    plain.SizePixels = height_px;
    atlas.AddFontDefault(&plain);
  }
  if (thumbnails_.rgba) {
    atlas.TexDesiredWidth = 1024;
    atlas.AddCustomRectRegular(static_cast<int>(thumbnails_.width_px), static_cast<int>(thumbnails_.height_px));
  }
  atlas.Build();
  ++letters_number_;
  if (thumbnails_.rgba) {
    const ImFontAtlasCustomRect& place = *atlas.GetCustomRectByIndex(0);
    unsigned char* pixels = nullptr;
    int row_px = 0, rows = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &row_px, &rows);
    for (std::size_t y = 0; y < place.Height; ++y) {
      const std::size_t row = (place.Y + y) * static_cast<std::size_t>(row_px) + place.X;
      std::memcpy(pixels + 4 * row, thumbnails_.rgba->data() + 4 * y * place.Width, std::size_t{4} * place.Width);
    }
  }
}

void UserInterface::set_thumbnails(TextureImage thumbnails) {
  thumbnails_ = std::move(thumbnails);
  make_letters();
}

UserInterface::Letters UserInterface::letters() const {
  Letters letters;
  unsigned char* pixels = nullptr;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &letters.width_px, &letters.height_px);
  letters.rgba = {pixels, 4 * static_cast<std::size_t>(letters.width_px) * static_cast<std::size_t>(letters.height_px)};
  letters.number = letters_number_;
  return letters;
}

void UserInterface::feed(const renderer::WindowEvent& event) { std::visit(Feeder{ImGui::GetIO()}, event); }

void UserInterface::begin_frame(int width_px, int height_px, double elapsed_s) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width_px), static_cast<float>(height_px)};
  io.DeltaTime = static_cast<float>(std::clamp(elapsed_s, 1e-4, 1.0));
  ImGui::NewFrame();
}

void UserInterface::end_frame() {
  ImGui::Render();
  const ImDrawData& drawn = *ImGui::GetDrawData();
  vertices_.resize(static_cast<std::size_t>(drawn.TotalVtxCount));
  indices_.clear();
  overlay_.parts.clear();
  picture_overlay_.parts.clear();
  std::size_t first_vertex = 0;
  for (int l = 0; l < drawn.CmdListsCount; ++l) {
    const ImDrawList& list = *drawn.CmdLists[l];
    std::memcpy(static_cast<void*>(vertices_.data() + first_vertex), list.VtxBuffer.Data,
                static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    const bool is_in_pictures = std::string_view(list._OwnerName).starts_with(in_pictures);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      overlay_.parts.push_back(
          {.clip_lower_px = {static_cast<int>(command.ClipRect.x), static_cast<int>(command.ClipRect.y)},
           .clip_upper_px = {static_cast<int>(command.ClipRect.z), static_cast<int>(command.ClipRect.w)},
           .first_index = indices_.size() + command.IdxOffset,
           .index_count = command.ElemCount,
           .first_vertex = first_vertex + command.VtxOffset});
      if (is_in_pictures) picture_overlay_.parts.push_back(overlay_.parts.back());
    }
    indices_.insert(indices_.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
    first_vertex += static_cast<std::size_t>(list.VtxBuffer.Size);
  }
  overlay_.vertices = picture_overlay_.vertices = vertices_;
  overlay_.indices = picture_overlay_.indices = indices_;
}

bool UserInterface::wants_pointer() const { return ImGui::GetIO().WantCaptureMouse; }

bool UserInterface::wants_keys() const { return ImGui::GetIO().WantTextInput; }

}  // namespace taut::app
