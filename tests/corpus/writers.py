"""Writes a Shape in formats of other programs, bytes and all, without any of their code."""
import base64
import struct
import zipfile


def triangles_of(shape):
    return [(f[0], f[k], f[k + 1]) for f in shape.faces for k in range(1, len(f) - 1)]


def obj(shape):
    text = ''.join('v %.9g %.9g %.9g\n' % p for p in shape.points)
    text += ''.join('f ' + ' '.join(str(v + 1) for v in f) + '\n' for f in shape.faces)
    text += ''.join('l %d %d\n' % (a + 1, b + 1) for a, b in shape.lines)
    text += ''.join('p %d\n' % (v + 1) for v in shape.lone_points)
    return text.encode()


def off(shape):
    text = 'OFF\n%d %d 0\n' % (len(shape.points), len(shape.faces))
    text += ''.join('%.9g %.9g %.9g\n' % p for p in shape.points)
    text += ''.join('%d %s\n' % (len(f), ' '.join(map(str, f))) for f in shape.faces)
    return text.encode()


def ply_header(shape, kind):
    return ('ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n'
            'element face %d\nproperty list uchar int vertex_indices\nend_header\n'
            % (kind, len(shape.points), len(shape.faces))).encode()


def ply(shape):
    text = ''.join('%.9g %.9g %.9g\n' % p for p in shape.points)
    text += ''.join('%d %s\n' % (len(f), ' '.join(map(str, f))) for f in shape.faces)
    return ply_header(shape, 'ascii') + text.encode()


def ply_binary(shape):
    data = b''.join(struct.pack('<fff', *p) for p in shape.points)
    data += b''.join(struct.pack('<B%di' % len(f), len(f), *f) for f in shape.faces)
    return ply_header(shape, 'binary_little_endian') + data


def stl(shape):
    text = 'solid cloth\n'
    for t in triangles_of(shape):
        text += ' facet normal 0 0 0\n  outer loop\n'
        text += ''.join('   vertex %.9g %.9g %.9g\n' % shape.points[v] for v in t)
        text += '  endloop\n endfacet\n'
    return (text + 'endsolid cloth\n').encode()


def stl_binary(shape):
    faces = triangles_of(shape)
    data = b'cloth'.ljust(80, b' ') + struct.pack('<I', len(faces))
    for t in faces:
        data += struct.pack('<fff', 0, 0, 0) + b''.join(struct.pack('<fff', *shape.points[v]) for v in t) + b'\0\0'
    return data


def gltf_arrays(shape):
    corners = [v for t in triangles_of(shape) for v in t]
    positions = b''.join(struct.pack('<fff', *p) for p in shape.points)
    return positions, struct.pack('<%dI' % len(corners), *corners), len(corners)


def gltf_json(shape, buffer, node):
    positions, indices, count = gltf_arrays(shape)
    as_float = [struct.unpack('<fff', struct.pack('<fff', *p)) for p in shape.points]
    low, high = ([f(p[k] for p in as_float) for k in range(3)] for f in (min, max))
    return ('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0%s}],'
            '"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":['
            '{"bufferView":0,"componentType":5126,"count":%d,"type":"VEC3","min":%s,"max":%s},'
            '{"bufferView":1,"componentType":5125,"count":%d,"type":"SCALAR"}],"bufferViews":['
            '{"buffer":0,"byteLength":%d},{"buffer":0,"byteOffset":%d,"byteLength":%d}],"buffers":[{"byteLength":%d%s}]}'
            % (node, len(shape.points), low, high, count, len(positions), len(positions), len(indices),
               len(positions) + len(indices), buffer))


def gltf(shape, node=''):
    positions, indices, _ = gltf_arrays(shape)
    data = base64.b64encode(positions + indices).decode()
    return gltf_json(shape, ',"uri":"data:application/octet-stream;base64,%s"' % data, node).encode()


def glb(shape):
    positions, indices, _ = gltf_arrays(shape)
    json = gltf_json(shape, '', '').encode()
    json += b' ' * (-len(json) % 4)
    data = positions + indices
    body = struct.pack('<II', len(json), 0x4E4F534A) + json + struct.pack('<II', len(data), 0x004E4942) + data
    return struct.pack('<III', 0x46546C67, 2, 12 + len(body)) + body


def dae(shape, metres=1.0, up='Y_UP', unit=True):
    numbers = ' '.join('%.9g %.9g %.9g' % p for p in shape.points)
    counts = ' '.join(str(len(f)) for f in shape.faces)
    corners = ' '.join(str(v) for f in shape.faces for v in f)
    asset = '<unit name="u" meter="%g"/>' % metres if unit else ''
    return ('<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
            '<asset>%s<up_axis>%s</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">'
            '<float_array id="a" count="%d">%s</float_array><technique_common><accessor source="#a" count="%d" '
            'stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>'
            '</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>'
            '<polylist count="%d"><input semantic="VERTEX" source="#v" offset="0"/><vcount>%s</vcount><p>%s</p>'
            '</polylist></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">'
            '<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene>'
            '<instance_visual_scene url="#s"/></scene></COLLADA>'
            % (asset, up, 3 * len(shape.points), numbers, len(shape.points), len(shape.faces), counts, corners)).encode()


def fbx(shape, centimetres=1.0, up_axis=1):
    numbers = ','.join('%.9g,%.9g,%.9g' % p for p in shape.points)
    corners = ','.join(','.join(map(str, f[:-1])) + ',%d' % (-f[-1] - 1) for f in shape.faces)
    return ('''; FBX 7.4.0 project file
FBXHeaderExtension:  {
  FBXVersion: 7400
}
GlobalSettings:  {
  Properties70:  {
    P: "UpAxis", "int", "Integer", "",%d
    P: "UpAxisSign", "int", "Integer", "",1
    P: "UnitScaleFactor", "double", "Number", "",%g
  }
}
Objects:  {
  Geometry: 100, "Geometry::cloth", "Mesh" {
    Vertices: *%d {
      a: %s
    }
    PolygonVertexIndex: *%d {
      a: %s
    }
  }
  Model: 200, "Model::cloth", "Mesh" {
    Version: 232
  }
}
Connections:  {
  C: "OO",200,0
  C: "OO",100,200
}
''' % (up_axis, centimetres, 3 * len(shape.points), numbers, sum(map(len, shape.faces)), corners)).encode()


def x3mf(shape, path):
    """A zip, so it is written to the path and not returned; times are fixed to keep its bytes the same."""
    model = ('<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
             '<resources><object id="1" type="model"><mesh><vertices>%s</vertices><triangles>%s</triangles></mesh>'
             '</object></resources><build><item objectid="1"/></build></model>'
             % (''.join('<vertex x="%.9g" y="%.9g" z="%.9g"/>' % p for p in shape.points),
                ''.join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in triangles_of(shape))))
    types = ('<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default '
             'Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default '
             'Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
    relations = ('<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
                 '<Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/'
                 '2013/01/3dmodel"/></Relationships>')
    with zipfile.ZipFile(path, 'w') as archive:
        for name, text in (('[Content_Types].xml', types), ('_rels/.rels', relations), ('3D/3dmodel.model', model)):
            archive.writestr(zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), text)
