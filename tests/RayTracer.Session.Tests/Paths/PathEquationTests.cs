using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session.Tests;

/// <summary>The numbers of an explanation are those of the renderer: factors multiply to what is shown, and what is shown adds up.</summary>
public sealed class PathEquationTests
{
    private const int Size = 48;
    private const int Samples = 36;

    public static TheoryData<string, string?> Scenes => new()
    {
        { "report/scene1.json", null },
        { "report/scene2.json", null },
        { "report/scene3.json", null },
        { "cornell.json", "path" },
        { "cornell.json", "direct" },
        { "cornell.json", "bidirectional" },
        { "cornell.json", "vcm" },
        { "cornell.json", "light" },
        { "materials/10-principled.json", null },
        { "materials/13-prism.json", "path" },
        { "materials/14-weakened-shadows.json", null },
        { "media/01-milk-and-fog.json", null },
        { "gallery/town.json", "path" },
        { "shapes.json", "path" },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Factors_multiply_and_contributions_add_up(string path, string? integrator)
    {
        Scene scene = Load(path, integrator);
        int arrived = 0;
        foreach (TracedPath traced in Pixels().SelectMany(p => new PathTracing(scene).Trace(p.X, p.Y, new(0, scene.Render.Integrator.Has(IntegratorTraits.TracesLight) ? 2 : Samples))))
        {
            AssertChain(traced);
            foreach (PathVertex vertex in traced.Vertices)
            {
                arrived += vertex.Lights.Count(l => l.Outcome == LightOutcome.Arrives);
                AssertLights(scene, vertex);
                AssertEmission(scene, vertex);
            }
        }

        Assert.True(arrived > 20 || integrator == "light" || path == "materials/13-prism.json", $"{arrived} points of lights");
    }

    [Theory]
    [InlineData("cornell.json", "bidirectional", "asked,connected,met,seen")]
    [InlineData("cornell.json", "vcm", "asked,connected,merged,met,seen")]
    [InlineData("cornell.json", "light", "seen")]
    [InlineData("cornell.json", "photons", "asked,merged")]
    [InlineData("gallery/prism.json", "bidirectional", "connected,seen")]
    [InlineData("media/01-milk-and-fog.json", "bidirectional", "asked,connected")]
    [InlineData("media/01-milk-and-fog.json", "vcm", "asked,connected")]
    public async Task Factors_of_ways_multiply_to_what_they_bring(string path, string integrator, string expected)
    {
        using TestSession test = new();
        string text = await File.ReadAllTextAsync(ProjectFolder.PathOf("scenes", path));
        await test.Open(JsonText.Of(text).Set("/render/integrator", integrator).Set("/render/width", Size).Set("/render/height", Size).Set("/render/samplesPerPixel", 2).Text, Path.GetDirectoryName(ProjectFolder.PathOf("scenes", path)));
        HashSet<string> events = [];
        await test.FilmHash();
        PathInspector inspector = test.Session.Part<PathInspector>();
        foreach ((int x, int y) in Pixels())
        {
            InspectedPixel pixel = await inspector.Inspect(x, y, 0, 2);
            foreach (InspectedWay way in pixel.Samples.SelectMany(s => s.Ways))
            {
                events.Add(way.Event);
                Rgb product = way.Factors.Aggregate(Rgb.White, (p, f) => f.Divides ? p * (1 / f.Value.R) : p * f.Value) * way.Weight;
                AssertNear(way.Radiance, product, 1e-3, 0);
                Assert.InRange(way.Weight, 0, 1 + 1e-4);
                Assert.Equal(way.Event == "merged", way.Factors.Any(f => f.Kind == WayFactor.Kernel));
                Assert.Equal(way.Event is "met" or "asked", way.Factors.Any(f => f.Kind == WayFactor.Radiance));
                Assert.Equal(way.Event is "asked" or "connected" or "merged", way.Factors.Any(f => f.Kind == WayFactor.CameraBsdf));
                Assert.Equal(way.Event is "seen" or "connected", way.Factors.Any(f => f.Kind == WayFactor.LightBsdf));
            }
        }

        Assert.Equal([], expected.Split(',').Except(events));
    }

    [Theory]
    [InlineData("path", 4, 2)]
    [InlineData("report", 4, 1)]
    public void Samples_that_share_rays_and_several_points_are_explained(string integrator, int ways, int points)
    {
        Scene split = Load("cornell.json", integrator, ways);
        Scene several = Load("cornell.json", integrator, 1);
        foreach (Scene scene in new[] { split, several })
        {
            foreach (TracedPath traced in new PathTracing(scene).Trace(10, 30, new(0, Samples)))
            {
                AssertChain(traced);
                Assert.All(traced.Vertices, v => AssertLights(scene, v));
            }
        }

        int first = new PathTracing(several).Trace(10, 30, new(0, 1))[0].Vertices[0].Lights.Count;
        Assert.Equal(points, first);
    }

    [Fact]
    public void Lights_that_add_nothing_say_why()
    {
        Scene scene = Load("cornell.json", "path");
        List<TracedLight> lights = [.. Pixels().SelectMany(p => new PathTracing(scene).Trace(p.X, p.Y, new(0, Samples))).SelectMany(p => p.Vertices).SelectMany(v => v.Lights)];
        Assert.Contains(lights, l => l.Outcome == LightOutcome.Arrives);
        Assert.Contains(lights, l => l.Outcome == LightOutcome.Behind);
        TracedLight[] blocked = [.. lights.Where(l => l.Outcome == LightOutcome.Blocked)];
        Assert.NotEmpty(blocked);
        Assert.All(blocked, l => Assert.True(l.Contribution.IsBlack));
        Assert.InRange(blocked.Count(l => l.Blocker != SurfaceName.None), (int)(0.98 * blocked.Length), blocked.Length);
    }

    private static void AssertChain(TracedPath traced)
    {
        foreach ((PathVertex from, PathVertex to) in traced.Vertices.Zip(traced.Vertices.Skip(1)))
        {
            AssertNear(to.Throughput, from.Throughput * from.Dispersion * from.Weight * (1 / from.Survival) * to.Passed, 1e-3);
            if (from is { Bsdf: { } bsdf, Pdf: { } pdf, Position: not null })
            {
                AssertNear(from.Weight, bsdf * (from.Cosine / pdf), 2e-3);
            }
        }

        // What light paths bring to the lens comes first.
        Rgb sum = traced.Vertices[0].Before;
        foreach (PathVertex vertex in traced.Vertices)
        {
            Assert.Equal(sum, vertex.Before);
            sum = vertex.After;
        }

        Assert.Equal(traced.Radiance, sum);
    }

    private static void AssertLights(Scene scene, PathVertex vertex)
    {
        Rgb sum = Rgb.Black;
        foreach (TracedLight light in vertex.Lights)
        {
            Assert.InRange(light.Weight, -1e-6, 1 + 1e-4);
            sum += light.Contribution;
            if (light.Outcome == LightOutcome.Arrives)
            {
                Rgb product = vertex.Throughput * vertex.Dispersion * light.Radiance * light.Bsdf * light.Transmittance * (light.Cosine * light.Weight / light.Pdf);
                AssertNear(light.Contribution, product, 1e-3);
                if (light.ScatterPdf is { } other && !scene.Render.Integrator.Has(IntegratorTraits.TracesLight))
                {
                    Assert.Equal(1 / (1 + ((double)other / light.Pdf * other / light.Pdf)), light.Weight, 1e-3);
                }
            }
        }

        if (!scene.Render.Integrator.Has(IntegratorTraits.TracesLight))
        {
            Rgb direct = vertex.After + (vertex.AfterAmbient * -1);
            double rounding = 1e-6 * (vertex.After.R + vertex.After.G + vertex.After.B);
            AssertNear(direct, sum, 1e-3, rounding);
        }
    }

    private static void AssertEmission(Scene scene, PathVertex vertex)
    {
        if (vertex.Emission is not { } met || scene.Render.Integrator.Has(IntegratorTraits.TracesLight))
        {
            return;
        }

        AssertNear(vertex.AfterEmission + (vertex.Before * -1), vertex.Throughput * met.Radiance * met.Weight, 1e-3, 1e-6 * vertex.AfterEmission.Luminance);
        if (met is { ScatterPdf: { } scatter, LightPdf: { } asked } && met.Weight > 0)
        {
            Assert.Equal(1 / (1 + ((double)asked / scatter * asked / scatter)), met.Weight, 1e-3);
        }
    }

    private static void AssertNear(Rgb expected, Rgb actual, double relative, double absolute = 1e-7)
    {
        double most = (relative * (Math.Abs(expected.R) + Math.Abs(expected.G) + Math.Abs(expected.B))) + absolute;
        Assert.True(
            Math.Abs(expected.R - actual.R) <= most && Math.Abs(expected.G - actual.G) <= most && Math.Abs(expected.B - actual.B) <= most, $"{expected} is not {actual}");
    }

    private static IEnumerable<(int X, int Y)> Pixels() =>
        from y in Enumerable.Range(0, 5)
        from x in Enumerable.Range(0, 5)
        select ((x * 9) + 4, (y * 9) + 4);

    private static Scene Load(string path, string? integrator, int? splitting = null) => SceneLoader.Load(ProjectFolder.PathOf("scenes", path), s => s with
    {
        Render = s.Render with
        {
            Width = Size,
            Height = Size,
            SamplesPerPixel = Samples,
            Splitting = splitting ?? s.Render.Splitting,
            Integrator = integrator is null ? s.Render.Integrator : Integrator.Known.All.Single(i => i.Name == integrator),
        },
    }).Scene!;
}
