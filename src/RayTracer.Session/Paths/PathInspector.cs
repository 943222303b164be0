using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Shows how the light of a pixel came about: follows its samples once more, in the renderer's own stages.</summary>
/// <param name="view">The picture.</param>
public sealed class PathInspector(PictureView view) : ISessionPart<PathInspector>
{
    private const int MostPaths = 256;

    // Where light paths are traced, those of the whole picture are, for each sample.
    private const int MostWithLight = 4;

    /// <inheritdoc/>
    public static PathInspector Of(StudioSession session) => new(session.View);

    /// <summary>Follows some samples of a pixel.</summary>
    /// <param name="x">Column.</param>
    /// <param name="y">Row.</param>
    /// <param name="first">The first sample.</param>
    /// <param name="count">
    /// The number of paths; at most 256, or 4 where light paths are traced, and no more than the picture will have.
    /// </param>
    /// <exception cref="SessionException">There is no such pixel or sample.</exception>
    public async Task<InspectedPixel> Inspect(int x, int y, int first, int count)
    {
        ViewportScene shown = view.RequireShown();
        RenderDescription render = shown.Scene.Render;
        if (x < 0 || y < 0 || x >= render.Width || y >= render.Height || first < 0 || first >= render.SamplesPerPixel)
        {
            throw new SessionException(
                $"The picture has {render.Width}×{render.Height} pixels of {render.SamplesPerPixel} samples.", SessionFault.Missing);
        }

        int most = render.Integrator.Has(IntegratorTraits.TracesLight) ? MostWithLight : MostPaths;
        SampleRange samples = new(first, (int)Math.Min(first + (long)Math.Clamp(count, 1, most), render.SamplesPerPixel));
        (Rgb? mean, int rendered) = await view.Loop.ReadFilm((film, newest, _) =>
            newest.Picture == shown.Picture && film.SampleCount(x, y) is var n and > 0 ? ((Rgb?)film.Mean(x, y), (int)n)
                : (null, 0)).ConfigureAwait(false);
        return new(x, y, mean, rendered, render.SamplesPerPixel, [.. new PathTracing(shown.Scene).Trace(x, y, samples).Select(p => Of(shown, p))]);
    }

    private static InspectedPath Of(ViewportScene shown, TracedPath path)
    {
        PathVertex start = path.Vertices[0];
        InspectedVertex camera = new(
            "camera", start.Origin, null, "/camera", "camera", "", Rgb.White, Rgb.White, null, Difference(start.Before, default), new(
                Difference(default, default), Difference(default, default), Difference(start.Before, default)));
        return new(path.Sample, path.Radiance, [camera, .. path.Vertices.Select(v => Of(shown, v))], [.. path.Ways.Select(w => Of(shown, w))]);
    }

    // From where both parts are joined back to the light.
    private static InspectedWay Of(ViewportScene shown, TracedWay way)
    {
        IEnumerable<Vector3?> points = way.LightPath.Count == 0
            ? [way.CameraEnd, way.LightEnd]
            : [way.CameraEnd, .. way.LightPath.Reverse().Select(v => v.Position), way.LightPath[0].Origin];
        IReadOnlyList<string> things = [.. way.LightPath.Select(v => NameOf(shown, v))];
        return new(way.LightVertices, way.CameraVertices, EventOf(way), way.Radiance, way.Weight, things, [.. points.OfType<Vector3>().Where(IsFinite)]);
    }

    private static bool IsFinite(Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);

    private static string EventOf(TracedWay way) => way switch
    {
        { IsMerge: true } => "merged",
        { LightVertices: 0 } => "met",
        { LightVertices: 1 } => "asked",
        { CameraVertices: 1 } => "seen",
        _ => "connected",
    };

    private static InspectedVertex Of(ViewportScene shown, PathVertex v)
    {
        SurfaceName surface = v.Primitive < 0 ? SurfaceName.None : new(v.Primitive, v.Instance);
        MaterialDescription? material = v.Primitive < 0 ? null : shown.Scene.MaterialSourceOf(v.Primitive);
        return new(
            EventOf(v), v.Position ?? Outside(shown, v), v.Normal, shown.PointerOf(surface),
            NameOf(shown, v),
            material is null ? "" : NameOf(shown, material),
            v.Weight, v.Throughput, v.Pdf, Difference(v.After, v.Before),
            new(Difference(v.AfterEmission, v.Before), Difference(v.AfterAmbient, v.AfterEmission), Difference(v.After, v.AfterAmbient)));
    }

    private static string EventOf(PathVertex v) => v.Event switch
    {
        PathEvent.Diffuse => "diffuse",
        PathEvent.Specular => "specular",
        PathEvent.Missed => "miss",
        PathEvent.Absorbed => v.AfterEmission != v.Before ? "emission" : "absorbed",
        _ => "end",
    };

    // Exact, since doubles hold the difference of two floats that are not too far apart; so sums of them give the floats back.
    private static double[] Difference(Rgb after, Rgb before) =>
        [(double)after.R - before.R, (double)after.G - before.G, (double)after.B - before.B];

    // Far enough to be seen to leave.
    private static Vector3 Outside(ViewportScene shown, PathVertex v) => v.Origin + (v.Direction * (2 * shown.Extent.Size));

    private static string NameOf(ViewportScene shown, PathVertex v)
    {
        ShapeDescription? thing = v.Primitive < 0 ? null : shown.Scene.SourceOf(v.Primitive, v.Instance);
        return thing is null ? v.Position is null ? "background" : "medium" : thing.Name.Length > 0 ? thing.Name : TypeOf(thing);
    }

    private static string TypeOf(object record) => RecordType.Of(record.GetType()).Name;

    private static string NameOf(ViewportScene shown, MaterialDescription material) =>
        shown.Description.Materials.FirstOrDefault(m => ReferenceEquals(m.Value, material)).Key ?? TypeOf(material);
}

/// <summary>The paths whose light came to a pixel.</summary>
/// <param name="X">Column.</param>
/// <param name="Y">Row.</param>
/// <param name="Pixel">The mean of all samples rendered so far; null where there are none.</param>
/// <param name="Rendered">The number of these samples.</param>
/// <param name="Total">The number of samples that the picture will have.</param>
/// <param name="Samples">Some of its paths.</param>
public sealed record InspectedPixel(int X, int Y, Rgb? Pixel, int Rendered, int Total, IReadOnlyList<InspectedPath> Samples);

/// <summary>A light path, for people.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">The radiance that it brings.</param>
/// <param name="Vertices">From the camera to its end.</param>
/// <param name="Ways">The ways in which light came, where it is traced too; the brightest first.</param>
public sealed record InspectedPath(int Sample, Rgb Radiance, IReadOnlyList<InspectedVertex> Vertices, IReadOnlyList<InspectedWay> Ways);

/// <summary>A path from a light to the camera, made of a part of each, for people.</summary>
/// <param name="LightVertices">The vertices from the light, that on the light included.</param>
/// <param name="CameraVertices">The vertices from the camera, that on the lens included.</param>
/// <param name="Event">"met" (the camera's path meets the light), "asked" (it asks the light), "seen" (the light's path is connected with the
/// lens), "connected" or "merged".</param>
/// <param name="Radiance">The radiance that it brings to the pixel.</param>
/// <param name="Weight">The factor on it, for other ways make such paths too.</param>
/// <param name="Things">Names of what the part from the light meets.</param>
/// <param name="Points">From where both parts are joined back to the light.</param>
public sealed record InspectedWay(
    int LightVertices, int CameraVertices, string Event, Rgb Radiance, float Weight, IReadOnlyList<string> Things, IReadOnlyList<Vector3> Points);

/// <summary>A vertex of a light path, for people.</summary>
/// <param name="Event">"camera", "diffuse", "specular", "emission" (it ends on what shines), "absorbed", "end" (it is given up) or
/// "miss".</param>
/// <param name="Position">The position; for a miss, a point on the way out.</param>
/// <param name="Normal">The normal, on the ray's side; null where there is none.</param>
/// <param name="Pointer">The thing in the text; null where there is none.</param>
/// <param name="Name">The name of the thing.</param>
/// <param name="Material">The name of its material.</param>
/// <param name="Weight">The factor on the throughput: BSDF · cosine / pdf of the chosen direction.</param>
/// <param name="Throughput">The factor on light from here.</param>
/// <param name="Pdf">The density with which the direction was chosen, in 1/sr; null for mirror-like lobes, and where there is none.</param>
/// <param name="Contribution">The light that the path gathers here; these add up to its radiance without rounding.</param>
/// <param name="Parts">The parts of that light.</param>
public sealed record InspectedVertex(
    string Event, Vector3 Position, Vector3? Normal, string? Pointer, string Name, string Material, Rgb Weight, Rgb Throughput, float? Pdf,
    IReadOnlyList<double> Contribution, ContributionParts Parts);

/// <summary>The light that a path gathers at a vertex; red, green and blue each.</summary>
/// <param name="Emitted">The surface's own light, or the background's.</param>
/// <param name="Ambient">Ambient light.</param>
/// <param name="Direct">Light that comes from the sources, along any way where light is traced too.</param>
public sealed record ContributionParts(IReadOnlyList<double> Emitted, IReadOnlyList<double> Ambient, IReadOnlyList<double> Direct);
