using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Where something new is put in a picture: on what is seen there.</summary>
/// <param name="View">The place and the size, in round numbers.</param>
/// <param name="Point">The point that is seen.</param>
/// <param name="Ground">The unit normal of the surface at the point, towards the eye; null where nothing is seen.</param>
/// <param name="Shown">The picture.</param>
/// <param name="Pixel">The pixel of it.</param>
internal sealed record PlaceInView(SketchView View, Vector3 Point, Vector3? Ground, ViewportScene Shown, Vector2 Pixel)
{
    // The part of a new thing's size by which it may miss the surface, and by which a flat one lies above it.
    private const float Exact = 1e-4f;
    private const float Lift = 0.01f;

    // How many times larger or smaller than other new things a model may be before it is scaled.
    private const float Fits = 2;

    /// <summary>The place at a pixel.</summary>
    /// <param name="shown">The picture.</param>
    /// <param name="pixel">The pixel; null for the middle.</param>
    /// <exception cref="SessionException">There is no such pixel.</exception>
    public static PlaceInView At(ViewportScene shown, Vector2? pixel)
    {
        RenderDescription render = shown.Scene.Render;
        Vector2 at = pixel ?? (new Vector2(render.Width, render.Height) / 2);
        PickResult seen = Picking.At(shown, at.X, at.Y);
        Transform toCamera = CameraController.Local(shown);
        Transform toWorld = toCamera.Inverse();
        CameraDescription camera = shown.Camera;
        Vector3 local = seen.Position is { } met ? toCamera.Point(met) : camera.LookAt;
        (Vector3 right, _, Vector3 forward) = CameraMotion.Axes(camera);
        Vector3 towards = camera.Position - local;
        towards = towards.Norm() > 0 ? towards : -forward;
        float height = CameraMotion.HeightAt(camera, MathF.Max(-towards.Dot(forward), Exact * towards.Norm()), shown.Aspect);
        float size = Round(height / (8 * toCamera.Vector(Vector3.UnitX).Norm()));
        towards = toWorld.Vector(towards).Unit();
        right = toWorld.Vector(right).Unit();
        SketchView view = new(toWorld.Point(local), right, towards.Cross(right).Unit(), towards, size);
        return new(view with { Target = view.Snap(view.Target) }, Precision.Round(view.Target, Exact * size), seen.Normal, shown, at);
    }

    /// <summary>A size with one digit, so that new things have round numbers.</summary>
    public static float Round(float size)
    {
        float round = float.Parse(size.ToString("E0", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
        return round > 0 && float.IsFinite(round) ? round : 1;
    }

    /// <summary>
    /// Puts a thing that was just added down on the surface: its box, or what of it reaches farthest on a slant, touches it at the point. Where it would
    /// cut into something, it stands beside that, if there is room. A model gets a size that can be seen.
    /// </summary>
    /// <param name="text">The text, of which the thing is the last of its list.</param>
    /// <param name="pointer">The thing.</param>
    /// <param name="folder">The folder from which its file is looked for.</param>
    public JsonText PutDown(JsonText text, string pointer, string folder)
    {
        if (Ground is not { } up || Alone(text, pointer, folder) is not { } alone)
        {
            return text;
        }

        if (!alone.Box.IsFinite)
        {
            // A plane without end, in that of the surface, could not be distinguished from it.
            return ShapePlacement.Translate(text, pointer, up * (Lift * View.Size));
        }

        Vector3 half = (alone.Box.Maximum - alone.Box.Minimum) * 0.5f;
        float larger = MathF.Max(half.X, MathF.Max(half.Y, half.Z)) / View.Size;
        if (View.File is not null && larger > 0 && larger is < 1 / Fits or > Fits)
        {
            text = ShapePlacement.Scale(text, pointer, new(Round(1 / larger)), (alone.Box.Maximum + alone.Box.Minimum) * 0.5f);
            alone = Alone(text, pointer, folder) ?? alone;
        }

        NewBody body = new(alone.Scene, alone.Box, View.Size);
        Vector3 way = Point - body.Middle;
        float above = Below(body, up);
        above = above < Lift * View.Size ? Lift * View.Size : above;

        // Other things are sketched at the point but for rounding; models are where their files have them.
        Vector3 by = (View.File is null ? up * way.Dot(up) : way) + (up * above);
        by += new RoomBeside(this, Late(text, pointer, folder)).For(body, by);
        return ShapePlacement.Translate(text, pointer, Precision.Round(by, Exact * View.Size));
    }

    /// <summary>How high the middle of a body's box stands above a surface: models, which may have thin legs, stand on their boxes.</summary>
    /// <param name="body">The body.</param>
    /// <param name="up">The surface's unit normal.</param>
    public float Below(NewBody body, Vector3 up) => View.File is null ? body.Below(up) : body.Corners(up);

    // The thing as the renderer has it; null where it cannot be built.
    private static (Scene Scene, Bounds Box)? Alone(JsonText text, string pointer, string folder)
    {
        bool isLight = IsLight(pointer);
        Scene? alone = Build(text, folder, all => all with { Shapes = isLight ? [] : [all.Shapes[^1]], Lights = isLight ? [all.Lights[^1]] : [] });
        PlacedSurface[] surfaces = [.. alone?.Surfaces() ?? []];
        return surfaces.Length == 0 ? null : (alone!, surfaces.Aggregate(Bounds.Empty, (box, surface) => box.Union(surface.Bounds)));
    }

    // What else was added since the picture's scene was built: another click may come before that; null for nothing.
    private Scene? Late(JsonText text, string pointer, string folder)
    {
        bool isLight = IsLight(pointer);
        SceneDescription known = Shown.Good.Read.Description!;
        Scene? late = Build(text, folder, all => all with
        {
            Shapes = [.. all.Shapes.SkipLast(isLight ? 0 : 1).Skip(known.Shapes.Count)],
            Lights = [.. all.Lights.SkipLast(isLight ? 1 : 0).Skip(known.Lights.Count)],
        });
        return late?.Surfaces().Any() == true ? late : null;
    }

    private static bool IsLight(string pointer) => pointer.StartsWith("/lights", StringComparison.Ordinal);

    private static Scene? Build(JsonText text, string folder, Func<SceneDescription, SceneDescription> part) =>
        SceneLoader.Build(SceneReader.ReadText(text.Text, ""), folder, all => part(all) with { Environment = null }).Scene;
}
