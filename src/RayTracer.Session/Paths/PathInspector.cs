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

    /// <inheritdoc/>
    public static PathInspector Of(StudioSession session) => new(session.View);

    /// <summary>Follows some samples of a pixel.</summary>
    /// <param name="x">Column.</param>
    /// <param name="y">Row.</param>
    /// <param name="first">The first sample.</param>
    /// <param name="count">The number of paths; at most 256, and no more than the picture will have.</param>
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

        if (render.Integrator.Has(IntegratorTraits.TracesLight))
        {
            throw new SessionException(
                $"The {render.Integrator.Name} integrator makes a pixel of many light paths, from the camera and from the lights: to look into them one by one, choose path.",
                SessionFault.Missing);
        }

        SampleRange samples = new(first, (int)Math.Min(first + (long)Math.Clamp(count, 1, MostPaths), render.SamplesPerPixel));
        (Rgb? mean, int rendered) = await view.Loop.ReadFilm((film, newest, _) =>
            newest.Picture == shown.Picture && film.SampleCount(x, y) is var n and > 0 ? ((Rgb?)film.Mean(x, y), (int)n)
                : (null, 0)).ConfigureAwait(false);
        return new(x, y, mean, rendered, [.. new PathTracing(shown.Scene).Trace(x, y, samples).Select(p => Of(shown, p))]);
    }

    private static InspectedPath Of(ViewportScene shown, TracedPath path)
    {
        PathVertex start = path.Vertices[0];
        InspectedVertex camera = new(
            "camera", start.Origin, null, "/camera", "camera", "", Rgb.White, Rgb.White, null, Difference(default, default), new(
                Difference(default, default), Difference(default, default), Difference(default, default)));
        return new(path.Sample, path.Radiance, [camera, .. path.Vertices.Select(v => Of(shown, v))]);
    }

    private static InspectedVertex Of(ViewportScene shown, PathVertex v)
    {
        SurfaceName surface = v.Primitive < 0 ? SurfaceName.None : new(v.Primitive, v.Instance);
        ShapeDescription? thing = v.Primitive < 0 ? null : shown.Scene.SourceOf(v.Primitive, v.Instance);
        MaterialDescription? material = v.Primitive < 0 ? null : shown.Scene.MaterialSourceOf(v.Primitive);
        return new(
            EventOf(v), v.Position ?? Outside(shown, v), v.Normal, shown.PointerOf(surface),
            thing is null ? "background" : thing.Name.Length > 0 ? thing.Name : TypeOf(thing),
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

    private static string TypeOf(object record) => RecordType.Of(record.GetType()).Name;

    private static string NameOf(ViewportScene shown, MaterialDescription material) =>
        shown.Description.Materials.FirstOrDefault(m => ReferenceEquals(m.Value, material)).Key ?? TypeOf(material);
}

/// <summary>The paths whose light came to a pixel.</summary>
/// <param name="X">Column.</param>
/// <param name="Y">Row.</param>
/// <param name="Pixel">The mean of all samples rendered so far; null where there are none.</param>
/// <param name="Rendered">The number of these samples.</param>
/// <param name="Samples">Some of its paths.</param>
public sealed record InspectedPixel(int X, int Y, Rgb? Pixel, int Rendered, IReadOnlyList<InspectedPath> Samples);

/// <summary>A light path, for people.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">The radiance that it brings.</param>
/// <param name="Vertices">From the camera to its end.</param>
public sealed record InspectedPath(int Sample, Rgb Radiance, IReadOnlyList<InspectedVertex> Vertices);

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
/// <param name="Direct">Light that comes straight from the sources.</param>
public sealed record ContributionParts(IReadOnlyList<double> Emitted, IReadOnlyList<double> Ambient, IReadOnlyList<double> Direct);
