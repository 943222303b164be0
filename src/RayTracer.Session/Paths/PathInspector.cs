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
    /// <param name="count">How many; at most 256, and no more than the picture will have.</param>
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

        SampleRange samples = new(first, (int)Math.Min(first + (long)Math.Clamp(count, 1, MostPaths), render.SamplesPerPixel));
        (Rgb? mean, int rendered) = await view.Loop.ReadFilm((film, order, _) =>
            order.Picture == shown.Picture && film.SampleCount(x, y) is var n and > 0 ? ((Rgb?)film.Mean(x, y), (int)n)
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
