using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// The light paths of a pixel, one by one: together they are what the film gets, and each leads from the camera to a light.
/// Covers `SubpathTracing` and `TracedWay`.
/// </summary>
public class SubpathTracingTests
{
    private const int Samples = 3;

    [Theory]
    [InlineData("light", "two edges, from a camera that moves")]
    [InlineData("bidirectional", "a room with a ball of glass")]
    [InlineData("bidirectional", "an even sky and negative lobes of the filter")]
    [InlineData("bidirectional", "a cloud within a cloud, and a lamp across its boundary")]
    [InlineData("photons", "many lights")]
    [InlineData("vcm", "prisms")]
    [InlineData("vcm", "sky and sun above a plane without end")]
    [InlineData("vcm", "things that overlap, by priorities")]
    public void Ways_add_up_to_the_sample_of_the_film_and_lead_to_lights(string integrator, string name)
    {
        Scene scene = Build(LightPathScene.All.Single(s => s.Name == name).Text, integrator);
        HashSet<(bool, bool, bool)> kinds = [];
        for (int pixel = 0; pixel < scene.Render.Width * scene.Render.Height; pixel += 37)
        {
            (int x, int y) = (pixel % scene.Render.Width, pixel / scene.Render.Width);
            foreach (TracedPath path in new PathTracing(scene).Trace(x, y, new(0, Samples)))
            {
                AssertNear(Sample(scene, x, y, path.Sample), path.Radiance, 1e-4);
                AssertNear(path.Radiance, path.Vertices[^1].After, 0);
                if (path.Ways.Count < 64)
                {
                    AssertNear(path.Radiance, path.Ways.Aggregate(Rgb.Black, (sum, w) => sum + w.Radiance), 1e-5);
                }

                foreach (TracedWay way in path.Ways)
                {
                    kinds.Add((way.LightVertices > 1, way.CameraVertices > 1, way.IsMerge));
                    AssertLeadsToALight(way);
                }
            }
        }

        Assert.True(kinds.Count >= (integrator == "light" ? 1 : integrator == "vcm" ? 3 : 2), string.Join(", ", kinds));
    }

    [Fact]
    public void Weights_multiply_to_the_throughput_on_the_way_from_the_camera_and_from_the_light()
    {
        Scene scene = Build(LightPathScene.All[0].Text, "vcm");
        int checkedCount = 0;
        for (int pixel = 5; pixel < scene.Render.Width * scene.Render.Height; pixel += 41)
        {
            foreach (TracedPath path in new PathTracing(scene).Trace(pixel % scene.Render.Width, pixel / scene.Render.Width, new(0, 2)))
            {
                IEnumerable<IReadOnlyList<PathVertex>> parts = [path.Vertices, .. path.Ways.Select(w => w.LightPath)];
                foreach ((PathVertex from, PathVertex to) in parts.SelectMany(p => p.Zip(p.Skip(1))))
                {
                    AssertNear(to.Throughput, from.Throughput * from.Weight, 1e-5);
                    checkedCount++;
                }
            }
        }

        Assert.True(checkedCount > 100, $"{checkedCount}");
    }

    private static void AssertLeadsToALight(TracedWay way)
    {
        Assert.InRange(way.Weight, -1e-5f, 1 + 1e-5f);
        Assert.Equal(Math.Max(0, way.LightVertices - 1), way.LightPath.Select(v => v.Number).Distinct().Count());
        Assert.Equal(way.LightVertices > 0, way.LightEnd is not null);
        if (way.LightVertices > 1)
        {
            Assert.Equal(way.LightEnd, way.LightPath[^1].Position);
        }

        if (way.IsMerge)
        {
            Assert.InRange(Vector3.Distance(way.LightEnd!.Value, way.CameraEnd!.Value), 0, 0.1);
        }
    }

    private static Rgb Sample(Scene scene, int x, int y, int sample)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
        new RTracer(scene, new() { Threads = 2, Crop = new(x, y, 1, 1), Samples = new(sample, sample + 1) }).Render(film);
        return film.Mean(x, y);
    }

    private static void AssertNear(Rgb expected, Rgb actual, double relative)
    {
        double most = (relative * (Math.Abs(expected.R) + Math.Abs(expected.G) + Math.Abs(expected.B))) + (relative * 1e-3);
        Assert.InRange(actual.R, expected.R - most, expected.R + most);
        Assert.InRange(actual.G, expected.G - most, expected.G + most);
        Assert.InRange(actual.B, expected.B - most, expected.B + most);
    }

    private static Scene Build(string text, string integrator) => SceneLoader.Build(SceneReader.ReadText(text, "test.json"), ".", d => d with
    {
        Render = d.Render with { Integrator = Integrator.Known.All.Single(i => i.Name == integrator), SamplesPerPixel = Samples, MergeRadius = 0.05f },
    }).Scene!;
}
