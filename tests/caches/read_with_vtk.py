#!/usr/bin/env python3
"""VTK reads what Taut wrote for it.   read_with_vtk.py FOLDER"""
import json
import pathlib
import sys

import vtk

folder = pathlib.Path(sys.argv[1])
records = [json.loads(line) for line in (folder / 'run.jsonl').read_text().splitlines() if '"frame"' in line]
for frame in (0, 17, 40):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(folder / ('clip/clip_%04d.vtp' % frame)))
    reader.Update()
    surface = reader.GetOutput()
    assert surface.GetNumberOfPoints() == 120 and surface.GetNumberOfPolys() == 156, (surface.GetNumberOfPoints(), surface.GetNumberOfPolys())
    expected = {tuple(map(float, line.split()[1:])) for line in (folder / ('shapes/%02d.obj' % frame)).read_text().splitlines()
                if line.startswith('v ')}
    assert {surface.GetPoint(k) for k in range(120)} == expected, 'positions of frame %d' % frame
    for data in (surface.GetCellData(), surface.GetPointData()):
        assert abs(data.GetArray('stretch').GetRange()[1] - records[frame]['max_surface_stretch']) < 1e-12
    assert surface.GetFieldData().GetArray('TimeValue').GetValue(0) == records[frame]['time_s']
    assert surface.GetFieldData().HasArray('smallest_distance')
