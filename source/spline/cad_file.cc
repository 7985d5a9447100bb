// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/cad_file.h>

#include <deal.II/base/config.h>

#include <algorithm>
#include <filesystem>

#ifdef DEAL_II_WITH_OPENCASCADE
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepTools.hxx>
#include <Geom_BSplineSurface.hxx>
#include <GeomConvert.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Standard_Failure.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#endif

namespace semilunar::spline
{
  namespace
  {
    std::string extension(const std::string &filename)
    {
      std::string text = std::filesystem::path(filename).extension().string();
      std::transform(text.begin(), text.end(), text.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return text;
    }

    bool is_step(const std::string &filename)
    {
      return extension(filename) == ".step" || extension(filename) == ".stp";
    }

    bool is_iges(const std::string &filename)
    {
      return extension(filename) == ".iges" || extension(filename) == ".igs";
    }
  } // namespace

  bool is_cad_file(const std::string &filename)
  {
    return is_step(filename) || is_iges(filename);
  }

#ifdef DEAL_II_WITH_OPENCASCADE
  namespace
  {
    /// OpenCASCADE prints statistics to standard output otherwise.
    void be_quiet()
    {
      Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    }

    const char *const no_surfaces = "holds no surfaces";
    const char *const export_surfaces = "export B-spline surfaces, not only curves or triangles";

    /// What OpenCASCADE complains about in its own words.
    InputError not_understood(const std::string &filename, const Standard_Failure &failure)
    {
      return InputError(filename, "",
                        std::string("OpenCASCADE cannot handle it: ") + failure.GetMessageString(),
                        "export the surfaces anew");
    }

    /// OpenCASCADE's own unit, to which it converts what it reads, is the millimetre.
    constexpr double millimetres_per_cm = 10.;

    template <typename Reader>
    TopoDS_Shape read_shape(const std::string &filename)
    {
      be_quiet();
      Reader reader;
      if (!std::filesystem::is_regular_file(filename) ||
          reader.ReadFile(filename.c_str()) != IFSelect_RetDone)
        throw InputError(filename, "", "is not a readable STEP or IGES file",
                         "check the name, and whether the file is complete");
      reader.TransferRoots();
      return reader.OneShape();
    }

    /// Whether the face is the whole rectangle of its parameters.
    bool is_rectangle(const TopoDS_Face &face)
    {
      double u0, u1, v0, v1;
      BRepTools::UVBounds(face, u0, u1, v0, v1);
      const double tolerance = 1e-6 * std::max(u1 - u0, v1 - v0);
      constexpr unsigned int n_samples = 8; // of each edge: a circle touches its box in some points
      for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
      {
        const BRepAdaptor_Curve2d curve(TopoDS::Edge(edge.Current()), face);
        for (unsigned int k = 1; k < n_samples; ++k)
        {
          const double share = double(k) / n_samples;
          const gp_Pnt2d p =
              curve.Value((1. - share) * curve.FirstParameter() + share * curve.LastParameter());
          const double inside = std::min({std::abs(p.X() - u0), std::abs(p.X() - u1),
                                          std::abs(p.Y() - v0), std::abs(p.Y() - v1)});
          if (inside > tolerance)
            return false;
        }
      }
      return true;
    }

    std::vector<double> knot_sequence(const TColStd_Array1OfReal &knots)
    {
      return {knots.begin(), knots.end()};
    }

    NurbsPatch to_patch(const TopoDS_Face &face, const std::string &filename)
    {
      const Handle(Geom_BSplineSurface) whole =
          Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
      if (whole.IsNull() || !is_rectangle(face))
        throw InputError(filename, "", "a face is trimmed: it is not bounded by parameter lines",
                         "export untrimmed B-spline surfaces");
      double u0, u1, v0, v1;
      BRepTools::UVBounds(face, u0, u1, v0, v1);
      const Handle(Geom_BSplineSurface) part =
          GeomConvert::SplitBSplineSurface(whole, u0, u1, v0, v1, 1e-9);
      const int n = part->NbUPoles(), m = part->NbVPoles();
      const bool reversed = face.Orientation() == TopAbs_REVERSED;
      std::vector<ControlPoint> net;
      for (int j = 1; j <= m; ++j)
        for (int i = 1; i <= n; ++i)
        {
          const int k = reversed ? n + 1 - i : i; // turns the normal round
          const gp_Pnt pole = part->Pole(k, j);
          net.push_back(
              {Point<3>(pole.X(), pole.Y(), pole.Z()) / millimetres_per_cm, part->Weight(k, j)});
        }
      std::vector<double> first = knot_sequence(part->UKnotSequence());
      if (reversed)
      {
        const double sum = first.front() + first.back();
        std::reverse(first.begin(), first.end());
        for (double &t : first)
          t = sum - t;
      }
      return NurbsPatch({{KnotVector(part->UDegree(), first),
                          KnotVector(part->VDegree(), knot_sequence(part->VKnotSequence()))}},
                        net);
    }

    struct KnotsAndMultiplicities
    {
      TColStd_Array1OfReal knots;
      TColStd_Array1OfInteger multiplicities;

      explicit KnotsAndMultiplicities(const KnotVector &vector)
          : knots(1, vector.breakpoints().size()), multiplicities(1, vector.breakpoints().size())
      {
        const std::vector<double> points = vector.breakpoints(), &all = vector.knots();
        for (unsigned int k = 0; k < points.size(); ++k)
        {
          knots.SetValue(k + 1, points[k]);
          multiplicities.SetValue(k + 1, std::count(all.begin(), all.end(), points[k]));
        }
      }
    };

    TopoDS_Face to_face(const NurbsPatch &patch)
    {
      const int n = patch.n_control_points(0), m = patch.n_control_points(1);
      TColgp_Array2OfPnt poles(1, n, 1, m);
      TColStd_Array2OfReal weights(1, n, 1, m);
      for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
        {
          const ControlPoint &point = patch.control_point(i, j);
          const Tensor<1, 3> x = millimetres_per_cm * point.position;
          poles.SetValue(i + 1, j + 1, gp_Pnt(x[0], x[1], x[2]));
          weights.SetValue(i + 1, j + 1, point.weight);
        }
      const KnotsAndMultiplicities u(patch.knots(0)), v(patch.knots(1));
      const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
          poles, weights, u.knots, v.knots, u.multiplicities, v.multiplicities,
          patch.knots(0).degree(), patch.knots(1).degree());
      constexpr double same_point = 1e-7; // mm
      return BRepBuilderAPI_MakeFace(surface, same_point).Face();
    }
  } // namespace

  std::vector<NurbsPatch> read_cad(const std::string &filename)
  {
    try
    {
      const TopoDS_Shape shape = is_step(filename) ? read_shape<STEPControl_Reader>(filename)
                                                   : read_shape<IGESControl_Reader>(filename);
      if (shape.IsNull())
        throw InputError(filename, "", no_surfaces, export_surfaces);
      std::vector<NurbsPatch> patches;
      const TopoDS_Shape converted = BRepBuilderAPI_NurbsConvert(shape).Shape();
      for (TopExp_Explorer face(converted, TopAbs_FACE); face.More(); face.Next())
        patches.push_back(to_patch(TopoDS::Face(face.Current()), filename));
      if (patches.empty())
        throw InputError(filename, "", no_surfaces, export_surfaces);
      return patches;
    }
    catch (const Standard_Failure &failure)
    {
      throw not_understood(filename, failure);
    }
  }

  namespace
  {
    bool write_shape(const TopoDS_Shape &shape, const std::string &filename)
    {
      if (is_step(filename))
      {
        STEPControl_Writer writer;
        return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
               writer.Write(filename.c_str()) == IFSelect_RetDone;
      }
      IGESControl_Writer writer("MM", 0);
      const bool added = writer.AddShape(shape);
      writer.ComputeModel();
      return added && writer.Write(filename.c_str());
    }
  } // namespace

  void write_cad(const std::vector<NurbsPatch> &patches, const std::string &filename)
  {
    be_quiet();
    bool written = false;
    try
    {
      BRep_Builder builder;
      TopoDS_Compound compound;
      builder.MakeCompound(compound);
      for (const NurbsPatch &patch : patches)
        builder.Add(compound, to_face(patch));
      written = write_shape(compound, filename);
    }
    catch (const Standard_Failure &failure)
    {
      throw not_understood(filename, failure);
    }
    if (!written)
      throw InputError(filename, "", "the file cannot be written",
                       "does its folder exist, and is there space on the disk?");
  }
#else
  namespace
  {
    InputError unavailable(const std::string &filename)
    {
      return InputError(filename, "", "this program was built without OpenCASCADE",
                        "build with a deal.II that has it");
    }
  } // namespace

  std::vector<NurbsPatch> read_cad(const std::string &filename)
  {
    throw unavailable(filename);
  }

  void write_cad(const std::vector<NurbsPatch> &, const std::string &filename)
  {
    throw unavailable(filename);
  }
#endif
} // namespace semilunar::spline
