using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Shows how the light of a pixel came about: follows its samples once more, in the renderer's own stages.</summary>
/// <param name="view">The picture.</param>
/// <param name="textbook">Its scene in the textbook edition.</param>
public sealed class PathInspector(PictureView view, TextbookReading textbook) : ISessionPart<PathInspector>
{
    private const int MostPaths = 256;

    // Where light paths are traced, those of the whole picture are, for each sample.
    private const int MostWithLight = 4;

    // Nobody reads so many, but their sum is that of nearly all.
    private const int MostSummedWays = 4096;
    private const int MostWays = 64;

    /// <inheritdoc/>
    public static PathInspector Of(StudioSession session) => new(session.View, session.Part<TextbookReading>());

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
        SampleRange samples = Check(shown, x, y, first, count);
        (Rgb? mean, int rendered) = await view.Loop.ReadFilm((film, newest, _) =>
            newest.Picture == shown.Picture && film.SampleCount(x, y) is var n and > 0 ? ((Rgb?)film.Mean(x, y), (int)n)
                : (null, 0)).ConfigureAwait(false);
        return new(x, y, mean, rendered, shown.Scene.Render.SamplesPerPixel, [.. Trace(shown, x, y, samples)]);
    }

    /// <summary>Adds up where the light of a pixel comes from, over as many of its samples as can be followed at once.</summary>
    /// <param name="x">Column.</param>
    /// <param name="y">Row.</param>
    /// <exception cref="SessionException">There is no such pixel.</exception>
    public PixelSummary Summarize(int x, int y)
    {
        ViewportScene shown = view.RequireShown();
        return PixelSummary.Of([.. Trace(shown, x, y, Check(shown, x, y, 0, MostPaths), MostSummedWays)], shown.Scene.Render.Integrator);
    }

    private IEnumerable<InspectedPath> Trace(ViewportScene shown, int x, int y, SampleRange samples, int mostWays = MostWays) =>
        textbook.Read(shown) is { } renderer ? new TextbookPaths(shown, renderer).Trace(x, y, samples)
            : new PathTracing(shown.Scene) { MostWays = mostWays }.Trace(x, y, samples).Select(p => Of(shown, p));

    internal static SampleRange Check(ViewportScene shown, int x, int y, int first, int count)
    {
        RenderDescription render = shown.Scene.Render;
        if (x < 0 || y < 0 || x >= render.Width || y >= render.Height || first < 0 || first >= render.SamplesPerPixel)
        {
            throw new SessionException(
                $"The picture has {render.Width}×{render.Height} pixels of {render.SamplesPerPixel} samples.", SessionFault.Missing);
        }

        int most = render.Integrator.Has(IntegratorTraits.TracesLight) ? MostWithLight : MostPaths;
        return new(first, (int)Math.Min(first + (long)Math.Clamp(count, 1, most), render.SamplesPerPixel));
    }

    private static InspectedPath Of(ViewportScene shown, TracedPath path)
    {
        PathVertex start = path.Vertices[0];
        InspectedVertex camera = new(
            "camera", start.Origin, null, "/camera", "camera", "", Rgb.White, Rgb.White, null, Difference(start.Before, default), new(
                Difference(default, default), Difference(default, default), Difference(start.Before, default)));
        InspectedVertex[] vertices = [camera, .. path.Vertices.Select((v, i) => Of(shown, v, Before(shown, path.Vertices, i)))];
        InspectedWay[] ways = [.. path.Ways.Select(w => Of(shown, w, path.Vertices))];
        string sentence = ways.Length > 0
            ? PathSentence.OfWay(ways[0], [.. path.Ways[0].LightPath.Select(v => (NameOf(shown, v), v))], vertices, path.Vertices.ToList().FindLastIndex(v => v.Number + 2 == ways[0].CameraVertices) + 1)
            : PathSentence.Of(path.Radiance, vertices, shown.Scene.Render.Integrator);
        return new(path.Sample, path.Radiance, vertices, ways, sentence);
    }

    // The vertex at which a ray was turned last: boundaries of media that it crosses leave its number as it is.
    private static PathVertex? Before(ViewportScene shown, IReadOnlyList<PathVertex> vertices, int at)
    {
        int i = at - 1;
        while (i >= 0 && shown.Scene.Render.Integrator is not ReportIntegrator && vertices[i].Number == vertices[at].Number)
        {
            i--;
        }

        return i < 0 ? null : vertices[i];
    }

    // From where both parts are joined back to the light.
    private static InspectedWay Of(ViewportScene shown, TracedWay way, IReadOnlyList<PathVertex> vertices)
    {
        IEnumerable<Vector3?> points = way.LightPath.Count == 0
            ? [way.CameraEnd, way.LightEnd]
            : [way.CameraEnd, .. way.LightPath.Reverse().Select(v => v.Position), way.LightPath[0].Origin];
        IReadOnlyList<string> things = [.. way.LightPath.Select(v => NameOf(shown, v))];
        return new(way.LightVertices, way.CameraVertices, EventOf(way), way.Radiance, way.Weight, things, [.. points.OfType<Vector3>().Where(IsFinite)])
        {
            Light = LightName(shown, way.Light) ?? NameOf(shown, vertices.Last(v => v.Number + 2 == way.CameraVertices)),
            Factors = [.. way.Factors.Select(f => new InspectedFactor(f.Kind, f.Value, f.Divides))],
        };
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

    private static InspectedVertex Of(ViewportScene shown, PathVertex v, PathVertex? before)
    {
        SurfaceName surface = v.Primitive < 0 ? SurfaceName.None : new(v.Primitive, v.Instance);
        MaterialDescription? material = v.Primitive < 0 ? null : shown.Scene.MaterialSourceOf(v.Primitive);
        return new(
            EventOf(v), v.Position ?? Outside(shown, v), v.Normal, shown.PointerOf(surface),
            NameOf(shown, v),
            material is null ? "" : NameOf(shown, material),
            v.Weight, v.Throughput, v.Pdf, Difference(v.After, v.Before),
            new(Difference(v.AfterEmission, v.Before), Difference(v.AfterAmbient, v.AfterEmission), Difference(v.After, v.AfterAmbient)))
        {
            Bsdf = v.Bsdf,
            Cosine = v.Cosine,
            Survival = v.Survival,
            End = NameOf(v.End),
            Passed = v.Passed,
            Dispersion = v.Dispersion,
            Emission = v.Emission is not { } met ? null : new(LightName(shown, met.Light) ?? NameOf(shown, v), met.Radiance, met.ScatterPdf, met.LightPdf, met.Weight)
            {
                // A background of one colour is found by scattering as well as it would be by asking.
                IsFoundOtherwise = (met.Light >= 0 && before is { Lights.Count: > 0 }) || (v.Position is null && shown.Scene.Environment is null),
            },
            Lights = [.. v.Lights.Select(l => Of(shown, v, l))],
        };
    }

    private static InspectedLight Of(ViewportScene shown, PathVertex v, TracedLight light)
    {
        ShapeDescription? source = shown.Scene.SourceOfLight(light.Light);
        Vector3 point = v.Position!.Value + (light.Direction * MathF.Min(light.Distance, 2 * shown.Extent.Size));
        string? blocker = light.Blocker == SurfaceName.None ? null : NameOf(shown.Scene.SourceOf(light.Blocker.Primitive, light.Blocker.Instance));
        return new(
            LightName(shown, light.Light)!, shown.PointerOf(source), OutcomeOf(light, source), blocker, shown.PointerOf(light.Blocker), light.Radiance, light.Pdf, light.ScatterPdf,
            light.Bsdf, light.Cosine, light.Weight, light.Transmittance, light.Contribution, IsFinite(point) ? point : null);
    }

    private static string? LightName(ViewportScene shown, int light) => light < 0 ? null : shown.Scene.SourceOfLight(light) is { } source ? NameOf(source) : "surroundings";

    internal static string NameOf(ShapeDescription? thing) => thing is null ? "" : thing.Name.Length > 0 ? thing.Name : TypeOf(thing);

    private static string OutcomeOf(TracedLight light, ShapeDescription? source) => light.Outcome switch
    {
        LightOutcome.Arrives => "arrives",
        LightOutcome.Unlit when source is SpotLightDescription => "outsideCone",
        LightOutcome.Unlit when source is ProjectorLightDescription => "outsidePicture",
        LightOutcome.Unlit => "unlit",
        LightOutcome.Behind => "behind",
        LightOutcome.Leaks => "leaks",
        LightOutcome.NotScattered => "notScattered",
        _ => "blocked",
    };

    private static string NameOf(PathEnd end) => end switch
    {
        PathEnd.Depth => "depth",
        PathEnd.Roulette => "roulette",
        PathEnd.Dark => "dark",
        PathEnd.Leaks => "leaks",
        PathEnd.Gathered => "gathered",
        _ => "",
    };

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
        return thing is null ? v.Position is null ? "background" : "medium" : NameOf(thing);
    }

    private static string TypeOf(object record) => RecordType.Of(record.GetType()).Name;

    internal static string NameOf(ViewportScene shown, MaterialDescription material) =>
        shown.Description.Materials.FirstOrDefault(m => ReferenceEquals(m.Value, material)).Key ?? TypeOf(material);
}
