#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Render a picture of a surface, or of a cut through a flow, coloured by a field.

Works on Bezier cells (divided by VTK) and on linear ones. Run it through pictures.sh, which sees to
VTK and a display.
"""
import argparse
import itertools
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import vtk

# Anchors of the viridis colour map, evenly spaced (M. van der Walt and N. Smith, CC0).
VIRIDIS = ("440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725")

# Direction from the focal point to the camera, and the direction that points up in the picture.
VIEWS = {
    "top": ((0, 0, 1), (0, 1, 0)),  # from the aortic side
    "side": ((0, -1, 0), (0, 0, 1)),
    "oblique": ((0.55, -0.75, 0.75), (0, 0, 1)),
}

SURFACE_SHARE = 0.82  # of the width of the picture; the rest is for the colours
BLACK, WHITE, GREY = (0, 0, 0), (1, 1, 1), (0.75, 0.75, 0.75)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path, help="folder of the run")
    parser.add_argument("--file", default="last",
                        help="last, first, or the name of a .vtu file in the folder")
    parser.add_argument("--field", default="mipe", help="field to colour by (default mipe)")
    parser.add_argument("--title", help="text above the colours (default: the field)")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"),
                        help="values at the ends of the colours (default: range of the field)")
    parser.add_argument("--with", dest="others", action="append", default=[], metavar="FILE",
                        help="another .vtu file of the folder, drawn in grey (may be repeated)")
    parser.add_argument("--cut", choices=("x", "y", "z"),
                        help="cut a volume (flow-*.vtu) by the plane on which this coordinate is --at")
    parser.add_argument("--at", type=float, default=0.0, help="where to cut (default 0)")
    parser.add_argument("--box", type=float, nargs=6,
                        metavar=("XMIN", "XMAX", "YMIN", "YMAX", "ZMIN", "ZMAX"),
                        help="draw only what lies in this box")
    parser.add_argument("--edges", action="store_true", help="draw the edges of a surface's cells, which then are flat")
    parser.add_argument("--view", choices=sorted(VIEWS), default="top")
    parser.add_argument("--size", type=int, nargs=2, default=(1400, 1100), metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--level", type=int, default=3,
                        help="how often Bezier cells are halved for drawing (default 3)")
    parser.add_argument("--out", type=Path, default=Path("picture.png"))
    return parser.parse_args()


def surface_file(run, wanted):
    """The .vtu file asked for: by name, or the first or last one of the run's collection."""
    if wanted not in ("first", "last"):
        return run / wanted
    collections = sorted(run.glob("*.pvd"))
    if run / "shell.pvd" in collections:  # of leaflets and blood, the leaflets
        collections = [run / "shell.pvd"]
    if len(collections) != 1:
        names = ", ".join(c.name for c in collections) or "none"
        sys.exit(f"{run}: expected one .pvd collection, found {names}; use --file NAME.vtu")
    files = [d.get("file") for d in ElementTree.parse(collections[0]).iter("DataSet")]
    return run / files[0 if wanted == "first" else -1]


def open_grid(path, box=None):
    """The unstructured grid in a file, without the cells outside of a box."""
    if not path.is_file():
        sys.exit(f"{path}: no such file")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    if not box:
        return reader.GetOutput()
    region = vtk.vtkBox()
    region.SetBounds(*box)
    extract = vtk.vtkExtractGeometry()
    extract.SetInputData(reader.GetOutput())
    extract.SetImplicitFunction(region)
    extract.Update()
    return extract.GetOutput()


def cut(path, axis, position, box):
    """Triangles of the cut of a volume by a plane."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(*[position if a == axis else 0 for a in "xyz"])
    plane.SetNormal(*[float(a == axis) for a in "xyz"])
    cutter = vtk.vtkCutter()
    cutter.SetInputData(open_grid(path, box))
    cutter.SetCutFunction(plane)
    cutter.Update()
    return cutter.GetOutput()


def read_triangles(path, level, box=None):
    """The surface as triangles with smooth normals, its cells divided `level` times."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(open_grid(path, box))
    surface.SetNonlinearSubdivisionLevel(level)
    merged = vtk.vtkCleanPolyData()  # elements do not share points in the file
    merged.SetInputConnection(surface.GetOutputPort())
    merged.SetTolerance(1e-6)  # of the diagonal of the surface's box
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(merged.GetOutputPort())
    normals.SetFeatureAngle(60)
    normals.Update()
    return normals.GetOutput()


def colour_map(low, high):
    table = vtk.vtkColorTransferFunction()
    for i, anchor in enumerate(VIRIDIS):
        rgb = [int(anchor[k:k + 2], 16) / 255 for k in (0, 2, 4)]
        table.AddRGBPoint(low + (high - low) * i / (len(VIRIDIS) - 1), *rgb)
    return table


def scalar_bar(table, title):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(title)
    bar.SetNumberOfLabels(6)
    bar.SetLabelFormat("%.3g")
    bar.SetUnconstrainedFontSize(True)
    for text, size in ((bar.GetTitleTextProperty(), 30), (bar.GetLabelTextProperty(), 26)):
        text.SetColor(*BLACK)
        text.SetFontSize(size)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    bar.SetVerticalTitleSeparation(15)
    bar.SetPosition(0.84, 0.2)
    bar.SetPosition2(0.14, 0.6)
    return bar


def shaded(data):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*GREY)
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.65)
    return actor


def boundary_lines(data):
    """The boundary curves of the surface: free edges, and where it is held."""
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(data)
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    actor = shaded(edges.GetOutput())
    actor.GetProperty().SetColor(*BLACK)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetLineWidth(2)
    return actor


def cell_edges(surface):
    """The edges of cells that are drawn without curvature."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(surface)
    edges.Update()
    actor = shaded(edges.GetOutput())
    actor.GetProperty().SetColor(*BLACK)
    actor.GetProperty().LightingOff()
    actor.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()  # lines before faces
    return actor


def coloured(data, field, limits):
    """The surface coloured by a field (the norm of a vector), and the map of the colours."""
    array = data.GetPointData().GetArray(field)
    if array is None:
        names = [data.GetPointData().GetArrayName(i)
                 for i in range(data.GetPointData().GetNumberOfArrays())]
        sys.exit(f"no field {field!r}; there are: {', '.join(names)}")
    is_vector = array.GetNumberOfComponents() > 1
    low, high = limits or array.GetFiniteRange(-1 if is_vector else 0)
    table = colour_map(low, high if high > low else low + 1)
    if is_vector:
        table.SetVectorModeToMagnitude()
    actor = shaded(data)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(table)
    mapper.InterpolateScalarsBeforeMappingOn()
    return actor, table


def aim(renderer, view, size):
    """Parallel projection that fills the part of the picture left of the colours."""
    bounds = renderer.ComputeVisiblePropBounds()
    direction, up = VIEWS[view]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*[(bounds[2 * d] + bounds[2 * d + 1]) / 2 for d in range(3)])
    camera.SetPosition(*[x + d for x, d in zip(camera.GetFocalPoint(), direction)])
    camera.SetViewUp(*up)
    renderer.ResetCamera()
    # the box around everything, seen by the camera
    to_camera = camera.GetViewTransformMatrix()
    corners = [to_camera.MultiplyPoint((*corner, 1))
               for corner in itertools.product(bounds[0:2], bounds[2:4], bounds[4:6])]
    half_width, half_height = (max(abs(c[d]) for c in corners) for d in (0, 1))
    aspect = size[0] / size[1]
    camera.SetParallelScale(1.05 * max(half_height, half_width / (aspect * SURFACE_SHARE)))
    camera.SetWindowCenter(1 - SURFACE_SHARE, 0)


def write_picture(renderer, size, out):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(*size)
    window.SetMultiSamples(8)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(out))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    arguments = parse_arguments()
    path = surface_file(arguments.run, arguments.file)
    if arguments.cut:
        surface = cut(path, arguments.cut, arguments.at, arguments.box)
    else:
        level = 0 if arguments.edges else arguments.level
        surface = read_triangles(path, level, arguments.box)
    actor, table = coloured(surface, arguments.field, arguments.range)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*WHITE)
    renderer.AddActor(actor)
    renderer.AddActor(boundary_lines(surface))
    if arguments.edges:
        renderer.AddActor(cell_edges(surface))
    for other in arguments.others:
        renderer.AddActor(shaded(read_triangles(arguments.run / other, arguments.level)))
    aim(renderer, arguments.view, arguments.size)
    renderer.AddActor2D(scalar_bar(table, arguments.title or arguments.field))
    write_picture(renderer, arguments.size, arguments.out)
    print(f"{arguments.out}: {arguments.field} of {path}, "
          f"{table.GetRange()[0]:.4g} to {table.GetRange()[1]:.4g}")


if __name__ == "__main__":
    main()
