// Drafts the T-shirt pattern and writes its outlines to standard output:
//   npm install && npm run draft
// or, for the measurements, the name and the ease at the biceps of another wearer,
//   node draft.mjs cisFemaleAdult34 female_34 0.3
// Not part of any build: it documents where teagan.toml comes from. FreeSewing drafts offline and always
// the same. config and plugin-transform are imported by its packages without being declared by them.
import * as models from '@freesewing/models'
import { Teagan } from '@freesewing/teagan'

const FLATNESS_MM = 0.02 // far below the 0.25 mm a cutter can follow: it keeps both sides of a seam equally long

const [size = 'cisMaleAdult40', wearer, biceps_ease] = process.argv.slice(2)
const measurements = models[size]
const draft = new Teagan({ measurements, options: wearer ? { bicepsEase: Number(biceps_ease) } : {}, sa: 0 })
draft.draft()
const parts = draft.parts[0]

const lerp = (a, b, t) => ({ x: a.x + (b.x - a.x) * t, y: a.y + (b.y - a.y) * t })
const distance = (a, b) => Math.hypot(b.x - a.x, b.y - a.y)
const length = (line) => line.slice(1).reduce((sum, point, i) => sum + distance(line[i], point), 0)

/** How far a point is from the straight line between two others. */
function deviation(point, from, to) {
  const span = distance(from, to)
  if (span === 0) return distance(point, from)
  return Math.abs((to.x - from.x) * (from.y - point.y) - (from.x - point.x) * (to.y - from.y)) / span
}

/** Points of a cubic Bezier curve after its first one, halved until its control points lie on the chord. */
function flatten([a, b, c, d]) {
  if (Math.max(deviation(b, a, d), deviation(c, a, d)) < FLATNESS_MM) return [d]
  const [ab, bc, cd] = [lerp(a, b, 0.5), lerp(b, c, 0.5), lerp(c, d, 0.5)]
  const [abc, bcd] = [lerp(ab, bc, 0.5), lerp(bc, cd, 0.5)]
  const middle = lerp(abc, bcd, 0.5)
  return [...flatten([a, ab, abc, middle]), ...flatten([middle, bcd, cd, d])]
}

/** The outline of a piece as one polyline for each of its drawing operations. */
function polylines(part) {
  const lines = []
  let at
  for (const op of parts[part].paths.seam.ops) {
    if (op.type === 'line') lines.push([at, op.to])
    if (op.type === 'curve') lines.push([at, ...flatten([at, op.cp1, op.cp2, op.to])])
    at = op.to ?? at
  }
  return lines
}

const join = (...lines) => lines.reduce((all, line) => [...all, ...line.slice(1)])

/** Cuts a polyline where its length so far reaches `at` millimetres. */
function split(line, at) {
  let done = 0
  for (let i = 1; i < line.length; i++) {
    const step = distance(line[i - 1], line[i])
    if (done + step >= at) {
      const cut = lerp(line[i - 1], line[i], (at - done) / step)
      return [[...line.slice(0, i), cut], [cut, ...line.slice(i)]]
    }
    done += step
  }
  throw new Error('the sleeve cap is shorter than the armhole')
}

function body(part) {
  const [hem, side_seam, hollow, pitch, shoulder_seam, neckline, fold] = polylines(part)
  return { hem, side_seam, armhole: join(hollow, pitch), shoulder_seam, neckline, fold }
}

/** The cap is cut where the shoulder seam meets it; the little ease there is goes evenly to both halves. */
function sleeve(front_armhole, back_armhole) {
  const [cuff, underarm_front, q1, q2, q3, q4, q5, underarm_back] = polylines('teagan.sleeve')
  const cap = join(q1, q2, q3, q4, q5)
  const front_share = length(front_armhole) / (length(front_armhole) + length(back_armhole))
  const [cap_front, cap_back] = split(cap, length(cap) * front_share)
  return { cuff, underarm_front, cap_front, cap_back, underarm_back }
}

function write(name, segments) {
  for (const [segment, line] of Object.entries(segments)) {
    const points = line.map(({ x, y }) => `[${x.toFixed(3)}, ${y.toFixed(3)}]`.replaceAll('-0.000', '0.000'))
    const rows = []
    for (let i = 0; i < points.length; i += 6) rows.push('  ' + points.slice(i, i + 6).join(', '))
    console.log(`\n# ${length(line).toFixed(2)} mm\n[${name}]`.replace(']', `.${segment}]`))
    console.log(`points_mm = [\n${rows.join(',\n')}\n]`)
  }
}

console.log(`# A T-shirt pattern: the cutting outlines without seam allowance, in millimetres, x right, y down, as drafted.
# Front and back are halves, to be mirrored at their fold (x = 0). The sleeve is the right one: its front is
# at positive x. The segments of a piece, in the order given, walk once around it.
[source]
pattern = "FreeSewing Teagan, a T-shirt"
package = "@freesewing/teagan"
version = "4.10.2"
measurements = "${size}"
homepage = "https://freesewing.eu/"
licence = "MIT, Copyright (c) 2022 Joost De Cock"
flatness_mm = ${FLATNESS_MM}`)
if (wearer) {
  // As the male shirt's, 2 cm below where the measurements have it.
  const neck_point_mm = measurements.waistToFloor + measurements.hpsToWaistBack - 20
  console.log(`\n[wearer]\nname = "${wearer}"\nbiceps_ease = ${biceps_ease}\nneck_point_height_m = ${(neck_point_mm / 1000).toFixed(3)}`)
}
const front = body('teagan.front')
const back = body('teagan.back')
write('front', front)
write('back', back)
write('sleeve', sleeve(front.armhole, back.armhole))
