using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes cameras.</summary>
internal sealed class PbrtCameras(ImportReading reading)
{
    private static readonly string[] s_types = ["perspective", "orthographic", "spherical"];

    // Ours looks along −z, and has x to the right and y up; theirs looks along z.
    private static readonly Transform s_forward = Transform.Scaling(new(1, 1, -1));

    // The middle of a picture of all directions is towards −x of the camera, and what is right of it towards −z.
    private static readonly Transform s_around = new(new(0, 0, 1, 0), new(0, 1, 0, 0), new(-1, 0, 0, 0));

    /// <summary>The camera; the usual one where none is given.</summary>
    /// <param name="camera">The thing.</param>
    /// <param name="film">The film's size and window.</param>
    public CameraDescription Read(PbrtThing? camera, FilmRead film)
    {
        if (camera is null)
        {
            return new() { Position = Vector3.Zero, LookAt = Vector3.UnitZ, FieldOfView = 90, FieldOfViewAxis = FieldOfViewAxis.Smaller, Window = film.Window };
        }

        if (!s_types.Contains(camera.Type))
        {
            camera.UnknownType(s_types);
        }

        bool isSpherical = camera.Type == "spherical";
        Transform view = isSpherical ? s_around : s_forward;
        PbrtPlaces places = camera.State.Places.Select(p => p.Inverse());
        CameraDescription made = places.Moves ? Matrix(view) with { Motion = PbrtMotion.Of(camera, places) } : Placed(places.Start * view);
        made = isSpherical ? Spherical(camera, made) : Flat(camera, made);
        made = Screen(camera, made with { Window = film.Window }, film.Render);
        camera.Finish();
        return reading.At(camera.Place, made);
    }

    /// <summary>When the shutter opens and closes; how long that is, is a factor on all light.</summary>
    public static Vector2 Shutter(PbrtThing? camera) => camera is null ? Vector2.UnitY : new(camera.Float("shutteropen", 0), camera.Float("shutterclose", 1));

    // By numbers where it is only turned and moved; else by a matrix, which may mirror.
    private static CameraDescription Placed(in Transform place)
    {
        if (place.Determinant > 0 && place.UniformScale() is { } scale && double.Abs(scale - 1) < 1e-4)
        {
            Vector3 eye = place.Point(Vector3.Zero);
            return new() { Position = eye, LookAt = eye - place.Vector(Vector3.UnitZ).Unit(), Up = place.Vector(Vector3.UnitY).Unit() };
        }

        return Matrix(place);
    }

    private static CameraDescription Matrix(in Transform place) => new() { Position = Vector3.Zero, LookAt = -Vector3.UnitZ, Up = Vector3.UnitY, Transform = MatrixSteps.Of(place) };

    private CameraDescription Spherical(PbrtThing camera, CameraDescription placed)
    {
        if (camera.Text("mapping") is not "equirectangular")
        {
            reading.Log.Unsupported(camera.PlaceOf("mapping"), "a spherical camera has the mapping \"equirectangular\" here", "it is used instead");
        }

        return placed with { Projection = Projection.Spherical };
    }

    private static CameraDescription Flat(PbrtThing camera, CameraDescription placed)
    {
        bool isOrthographic = camera.Type == "orthographic";
        float radius = camera.Float("lensradius", 0, 0);
        float focus = camera.Float("focaldistance", 1e6f, 0);
        return placed with
        {
            Projection = isOrthographic ? Projection.Orthographic : Projection.Perspective,
            FieldOfView = isOrthographic ? placed.FieldOfView : camera.Float("fov", 90, 0.001f, 179),
            ViewSize = 2,
            FieldOfViewAxis = FieldOfViewAxis.Smaller,
            Lens = radius > 0 ? new() { ApertureRadius = radius, FocusDistance = focus } : placed.Lens,
        };
    }

    // A window on the picture plane, in which the field of view is from −1 to 1: a part of a larger picture around the middle.
    private CameraDescription Screen(PbrtThing camera, CameraDescription made, RenderDescription render)
    {
        camera.Refuse("frameaspectratio", "pixels are square here: the ratio of width and height is that of the picture");
        if (camera.Floats("screenwindow") is not { Count: > 0 } w)
        {
            return made;
        }

        // Of the whole film.
        float across = made.Window.Count > 0 ? render.Width / made.Window[2] : render.Width;
        float up = made.Window.Count > 0 ? render.Height / made.Window[3] : render.Height;
        if (w.Count != 4 || !(w[0] < w[1] && w[2] < w[3]) || float.Abs(((w[1] - w[0]) * up) - ((w[3] - w[2]) * across)) > 1e-3f * (w[1] - w[0]) * up)
        {
            reading.Log.Unsupported(camera.PlaceOf("screenwindow"), "\"screenwindow\" must have four numbers, x and y from less to more, and the ratio of width and height of the film", "it is ignored");
            return made;
        }

        float x = float.Max(float.Abs(w[0]), float.Abs(w[1]));
        float y = float.Max(float.Abs(w[2]), float.Abs(w[3]));
        IReadOnlyList<float> inner = made.Window.Count > 0 ? made.Window : [0, 0, 1, 1];
        (float width, float height) = ((w[1] - w[0]) / (2 * x), (w[3] - w[2]) / (2 * y));
        LaneMath.SinCosTurn(made.FieldOfView / 720, out float sin, out float cos);
        return made with
        {
            FieldOfViewAxis = FieldOfViewAxis.Vertical,
            FieldOfView = LaneMath.Atan2(y * sin, cos) * (360 / float.Pi),
            ViewSize = 2 * y,
            Window = [((w[0] + x) / (2 * x)) + (inner[0] * width), ((y - w[3]) / (2 * y)) + (inner[1] * height), inner[2] * width, inner[3] * height],
        };
    }
}
