#include "app/scene/scene_format.hpp"
#include "app/viewer/panel/panel.hpp"

namespace taut::app {
namespace {

using Hint = std::pair<std::string_view, std::string_view>;

/// Of items that are no keys of a scene, and of keys of which there is more to say in the window.
constexpr std::array hints = {
    Hint{"wind.speed",
         "Speed of the wind in m/s, the paper's wind value. It holds on to 1.0 and 10.0, those of figure 5."
         " Keys: up, down."},
    Hint{"wind.direction", "Where the wind goes, seen from above: up is away from you. Keys: left, right."},
    Hint{"gravity", "How fast things fall, in m/s². On Earth 9.81."},
    Hint{"measured.stretch",
         "The largest stretch, in percent, over the last frames: of springs, or of the surface if the bound"
         " is for it. Red: the bound that bounded keeps, or the threshold of another solver."},
    Hint{"measured.stretches",
         "p99: 99 of 100 are stretched no more. A spring is stretched along itself, the surface along any"
         " direction in a triangle."},
    Hint{"measured.contact",
         "The distance of the two nearest triangles, or from a body, and how many cross: measured at each "
         "frame's end. "
         "What crosses since the start is left out of contact until it is apart."},
    Hint{"measured.convergence",
         "The longest way of a mass point in the last frame, |p(t) - p(t - dt)|, in"
         " millimetres."},
    Hint{"measured.times",
         "Milliseconds of the clock for the last frame: to simulate it, to draw the window, to lay out"
         " this panel."},
    Hint{"measured.size", "Triangles and vertices of the garment that is simulated."},
    Hint{"measured.speed",
         "Simulated seconds in a second of the clock, over the last second, and what keeps it from being"
         " as fast as asked."},
    Hint{"look.shaded", "Show the cloth as cloth."},
    Hint{"look.stretch", "Show the stretch as colours, in percent of the length at rest."},
    Hint{"look.stretch_of", "What the colours show the stretch of."},
    Hint{"look.stretch_of.springs", "At each vertex the largest stretch of the springs there."},
    Hint{"look.stretch_of.surface",
         "At each vertex the largest stretch of the triangles there, in any direction."},
    Hint{"look.wireframe", "Show the edges of the mesh, as far as cloth does not hide them."},
    Hint{"look.shadows", "Shadows of the key light on cloth and floor. Without, drawing is faster."},
    Hint{"look.springs", "Show springs, coloured by their kind."},
    Hint{"look.springs.none", "Show no springs."},
    Hint{"look.springs.structural", "The edges of the mesh."},
    Hint{"look.springs.shear", "The diagonals of a grid's cells."},
    Hint{"look.springs.flexural", "Those that skip a vertex, and resist bending."},
    Hint{"look.springs.all", "All kinds, the flexural ones under the others."},
    Hint{"look.normals", "Show which way the vertices' outsides face."},
    Hint{"scene",
         "Load a scene that comes with the program. Drop a scene's file on the window to load another."},
    Hint{"garment",
         "Put another garment into this scene. Drop a model's file on the window to load another."},
    Hint{"fabric",
         "Make the garment of another fabric: its weight, stiffness and look, from now on; "
         "the first is that of the scene as it was opened."},
    Hint{"motion",
         "Choose how the body moves, over and over. The scene begins anew, and the body is dressed again."},
    Hint{"solver",
         "How springs answer. bounded: ours, keeps its bound on stretch. strong: the paper's. ideal: Hooke's"
         " springs. provot, vassilev: those, held at a threshold. fast-projection: keeps lengths. implicit: "
         "large"
         " steps."},
    Hint{"compare",
         "Show the same garment a second time by another solver, in the same wind. Both begin anew and go on"
         " frame by frame together: the slower one holds both back. Hands, pins and the time bar act on"
         " both; scenes, shapes and clips are written of the left one."},
    Hint{"compare.none", "One garment alone."},
    Hint{"solver.ideal", "Hooke's springs alone: cloth stretches under its weight, and vibrates."},
    Hint{"solver.provot", "Hooke's springs, pulled back where they exceed the threshold (Provot 1995)."},
    Hint{"solver.strong", "The paper's strong constraint: sweeps over all springs in their order."},
    Hint{"solver.bounded",
         "The paper's equations, organised so that the bound on stretch is kept in every frame."},
    Hint{"solver.vassilev",
         "Hooke's springs, whose ends part no further beyond the threshold (Vassilev and others 2001)."},
    Hint{"solver.fast-projection",
         "Edges keep their lengths, all at once (Goldenthal and others 2007). Grids drape, triangles lock."},
    Hint{"solver.implicit", "Stiff cloth in large steps by backward Euler (Baraff and Witkin 1998)."},
    Hint{"solver.bound.springs", "Every spring along itself, as the paper has it."},
    Hint{"solver.bound.surface", "Every triangle along any direction, and with it the springs."},
    Hint{"fabric.bending",
         "Bending rigidity of the cloth, in millionths of a newton metre. Jersey 5, denim 98."},
    Hint{"fabric.compression",
         "Stiffness of springs that are shorter than at rest, in N/m. Less crumples sooner."},
    Hint{"solver.stiffness.flexural", "Stiffness of flexural springs, in N/m. Less bends more easily."},
    Hint{"solver.stiffness.damping",
         "Damping of every spring, in N s/m. More vibrates less, and needs shorter time"
         " steps."},
    Hint{"keep.screenshot", "Write what the scene shows as a PNG picture, without this panel."},
    Hint{"keep.scene", "Write all settings as a scene file, which taut render draws as the window does."},
    Hint{"keep.camera", "Copy the camera as lines of a scene file to the clipboard."},
    Hint{"keep.record",
         "Record what the scene shows, 30 pictures a second, without this panel; once more ends it."},
    Hint{"keep.video", "Record to a video, an MP4 file. Needs ffmpeg."},
    Hint{"keep.pictures", "Record to a folder of PNG pictures."},
    Hint{"keep.shape", "Write the cloth as it is now as an OBJ file, with the faces of its model."},
    Hint{
        "keep.clip",
        "Write the shape of every frame that is simulated from now on, as other programs read it, whatever is"
        " drawn; once more ends it. Going back, starting again or another scene ends it too."},
    Hint{"keep.clip_frames", "Frames of the clip so far, and the file that they go to."},
    Hint{"keep.clip_format", "What the clip is written as."},
    Hint{"keep.clip_format.PC2",
         "A point cache, and the rest shape that it moves as an OBJ file. For Blender."},
    Hint{"keep.clip_format.MDD", "LightWave's point cache, and the rest shape that it moves as an OBJ file."},
    Hint{"keep.clip_format.glTF",
         "One GLB file with all shapes and an animation, which plays in any viewer."},
    Hint{"keep.clip_format.VTK",
         "A PVD file and one VTP file a frame, with the triangles' stretch. For ParaView."},
    Hint{"keep.clip_format.OBJ", "One OBJ file a frame."},
    Hint{"time.pause", "Stop and go on. Key: space."},
    Hint{"time.step", "One frame, 1/60 s as scenes have it. Key: full stop."},
    Hint{"time.reset", "Start again, with the scene's pins and the present settings. Key: R."},
    Hint{"speed", "Simulated seconds in a second of the clock: 1 x is real time, less is slow motion."},
    Hint{"timeline", "The last seconds of the simulation: drag back to see them, Space goes on from there."},
};

}  // namespace

std::string hint_for(const std::string& name) {
  for (const auto& [own, text] : hints) {
    if (own == name) return std::string(text);
  }
  constexpr std::string_view compare = "compare.";
  if (name.starts_with(compare)) return hint_for("solver." + name.substr(compare.size()));
  constexpr std::string_view preset = "preset.";
  if (name.starts_with(preset)) return "Load the scene " + name.substr(preset.size()) + " of this figure.";
  static const std::vector<Key<Scene>> keys = scene_keys();
  const auto key = std::ranges::find(keys, name, &Key<Scene>::name);
  if (key == keys.end()) return "";
  const std::string unit = key->unit.empty() ? "" : ", in " + key->unit;
  return static_cast<char>(std::toupper(key->meaning[0])) + key->meaning.substr(1) + unit + '.';
}

}  // namespace taut::app
