using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

// A scene built in code, rendered with progress until it is done or Ctrl-C stops it, and read as numbers.
string image = args.Length > 0 ? args[0] : "spheres.png";
Scene scene = Scene.From(new SceneDescription
{
    Camera = new() { Position = new(0, 1, 5), LookAt = new(0, 0.5f, 0) },
    Render = new() { Width = 160, Height = 120, SamplesPerPixel = 16, Integrator = Integrator.Path },
    Background = "skyblue",
    Shapes =
    [
        new PlaneDescription { Normal = new(0, 1, 0), Material = new DiffuseMaterialDescription { Color = new Rgb(0.6f, 0.6f, 0.6f) } },
        new SphereDescription { Center = new(-0.8f, 0.7f, 0), Radius = 0.7f, Material = new DiffuseMaterialDescription { Color = "tomato" } },
        new SphereDescription { Center = new(0.8f, 0.7f, 0), Radius = 0.7f, Material = new DielectricMaterialDescription() },
    ],
    Lights = [new PointLightDescription { Position = new(3, 5, 4), Intensity = new(60, 60, 60) }],
});

using CancellationTokenSource stop = new();
Console.CancelKeyPress += (_, e) =>
{
    e.Cancel = true;
    stop.Cancel();
};
Film film = new(scene.Render.Width, scene.Render.Height);
RenderStatistics statistics = new RTracer(scene).Render(film, new PercentDone(), stop.Token);

Rgb middle = film[100, 60];
Console.WriteLine($"{(statistics.Cancelled ? "cancelled after" : "done with")} {film.TotalSamples:N0} samples and {statistics.Rays:N0} rays");
Console.WriteLine($"pixel (100, 60): {middle.R} {middle.G} {middle.B}, standard error {MathF.Sqrt(film.SampleVariance(100, 60) / film.SampleCount(100, 60))}");
Console.WriteLine($"film {film.ComputeHash()}");
ImageFile.Write(image, film);
return statistics.Cancelled ? 1 : 0;

/// <summary>Writes the progress in steps of ten per cent. Reports come from the rendering threads, one at a time.</summary>
internal sealed class PercentDone : IProgress<RenderProgress>
{
    private int _shown;

    public void Report(RenderProgress value)
    {
        int percent = (int)(value.Fraction * 10) * 10;
        if (percent > _shown)
        {
            Console.WriteLine($"{_shown = percent} %");
        }
    }
}
