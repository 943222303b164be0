using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Session;
using RayTracer.Textures;

namespace RayTracer.Benchmarks.Studio;

/// <summary>
/// Pictures while something moves, without a browser: FLIP of recorded ones against many samples, beside that of coarse previews, and their processor time.
/// <c>studio moving [--samples N] [--every N] [--write FOLDER] [SCENE…]</c>.
/// </summary>
internal sealed class MovingQuality(string[] args)
{
    private const int Width = 800;
    private const int Height = 600;
    private const int FirstFrame = 3;
    private const int Frames = 12;

    // How coarse previews were, on quiet cores.
    private const int OldScale = 4;
    private readonly int _samples = Option(args, "--samples", 1024);
    private readonly int _every = Option(args, "--every", 1);
    private readonly string? _folder = Array.IndexOf(args, "--write") is >= 0 and var at ? args[at + 1] : null;

    public int Run()
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("studio-bench-");
        try
        {
            Console.WriteLine($"| scene | motion | FLIP, mean | worst | of coarse previews | tracing | filter | display | together, at most |\n|---|---|---|---|---|---|---|---|---|");
            foreach (MovingScene scene in MovingScene.All(folder.FullName).Where(s => args.Contains(s.Name) || !MovingScene.All(folder.FullName).Any(o => args.Contains(o.Name))))
            {
                foreach (string motion in MovingScene.Motions.Where(m => args.Contains(m) || !MovingScene.Motions.Any(args.Contains)))
                {
                    Console.WriteLine(Row(scene, motion));
                }
            }

            return 0;
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private string Row(MovingScene scene, string motion)
    {
        MovingView view = new();
        LinearPicture picture = new();
        List<double> errors = [];
        List<double> before = [];
        List<(double Tracing, double Filter, double Display)> costs = [];
        byte[] rgba = new byte[4 * Width * Height];
        ViewportScene? shown = null;
        WarmUp(Shown(scene, motion, 0, null), picture);
        for (int frame = 0; frame < FirstFrame + Frames; frame++)
        {
            shown = Shown(scene, motion, frame, shown);
            view.Next(shown, picture, CancellationToken.None);
            TimeSpan made = Environment.CpuUsage.TotalTime;
            FramePixels.Write(picture, Tone.Of(shown.Scene.Render), 1, rgba);
            TimeSpan display = Environment.CpuUsage.TotalTime - made;
            if (frame < FirstFrame)
            {
                continue;
            }

            costs.Add((view.Cost.Tracing.TotalMilliseconds, view.Cost.Filter.TotalMilliseconds, display.TotalMilliseconds));
            if ((frame - FirstFrame) % _every == 0)
            {
                Picture reference = Rendered(shown, Width, Height, _samples, int.MaxValue);
                errors.Add(Flip(Larger(picture), reference, shown, $"{scene.Name}-{motion}-{frame}"));
                before.Add(Flip(Larger(Rendered(shown, Width / OldScale, Height / OldScale, 1, 1)), reference, shown, null));
            }
        }

        string Median(Func<(double Tracing, double Filter, double Display), double> part) => $"{costs.Select(part).Order().ElementAt(costs.Count / 2):F1} ms";
        return $"| {scene.Name} | {motion} | {errors.Average():F3} | {errors.Max():F3} | {before.Average():F3} | {Median(c => c.Tracing)} | {Median(c => c.Filter)} | {Median(c => c.Display)} | {Median(c => c.Tracing + c.Filter + c.Display)}, {scene.MostMilliseconds} ms |";
    }

    // So that no compiler is at work while times are taken.
    private static void WarmUp(ViewportScene shown, LinearPicture picture)
    {
        const int pictures = 60;
        MovingView view = new();
        byte[] rgba = new byte[4 * Width * Height];
        for (int i = 0; i < pictures; i++)
        {
            view.Next(shown, picture, CancellationToken.None);
            FramePixels.Write(picture, Tone.Of(shown.Scene.Render), 1, rgba);
        }
    }

    private static ViewportScene Shown(MovingScene scene, string motion, int frame, ViewportScene? before)
    {
        bool isSame = motion == "orbit" && before is not null;
        GoodScene good = isSame ? before!.Good : Good(scene, scene.TextAt(motion, frame), frame);
        CameraDescription camera = motion == "orbit" ? CameraMotion.Orbit(good.Read.Description!.Camera, 0.01f * frame, 0.004f * frame) : good.Read.Description!.Camera;
        RenderDescription render = good.Scene.Render with { Width = Width, Height = Height };
        Scene seen = good.Scene.WithView(camera, render, new((_, _) => new(1, 1)))!;
        return new(good, seen, camera, new() { Threads = 1 });
    }

    private static GoodScene Good(MovingScene scene, string text, int revision)
    {
        SceneReadResult read = SceneReader.ReadText(text, scene.Path);
        SceneLoadResult load = SceneLoader.Build(read, Path.GetDirectoryName(scene.Path)!);
        return new(revision, text, read, load.Scene ?? throw new InvalidDataException(string.Join("\n", load.Diagnostics)));
    }

    private static Picture Rendered(ViewportScene shown, int width, int height, int samples, int depth)
    {
        RenderDescription render = shown.Scene.Render;
        render = render with { Width = width, Height = height, SamplesPerPixel = samples, MaxDiffuseDepth = Math.Min(render.MaxDiffuseDepth, depth) };
        return new RTracer(shown.Scene.WithView(shown.Camera, render, new((_, _) => new(1, 1)))!).Render().Film.ToPicture();
    }

    private double Flip(Picture picture, Picture reference, ViewportScene shown, string? name)
    {
        (Picture a, Picture b) = (Display(picture, shown), Display(reference, shown));
        if (_folder is not null && name is not null)
        {
            Directory.CreateDirectory(_folder);
            ImageFile.Write(Path.Combine(_folder, $"{name}.png"), a);
            ImageFile.Write(Path.Combine(_folder, $"{name}-reference.png"), b);
        }

        return FlipError.Compare(a, b, 67).Mean;
    }

    private static Picture Display(Picture picture, ViewportScene shown)
    {
        Tone tone = Tone.Of(shown.Scene.Render);
        float factor = MathF.Pow(2, tone.Exposure.StopsFor(picture));
        Picture display = new(picture.Width, picture.Height);
        for (int i = 0; i < picture.Pixels.Length; i += 3)
        {
            Numerics.Rgb seen = ToneMapping.Apply(tone.ToneMap, new Numerics.Rgb(picture.Pixels[i], picture.Pixels[i + 1], picture.Pixels[i + 2]) * factor);
            (display.Pixels[i], display.Pixels[i + 1], display.Pixels[i + 2]) = (seen.R, seen.G, seen.B);
        }

        return display;
    }

    // As a browser enlarges it.
    private static Picture Larger(IImageRows picture)
    {
        LinearPicture from = new();
        from.CopyFrom(picture);
        Picture to = new(Width, Height);
        for (int y = 0; y < Height; y++)
        {
            float fy = Math.Clamp(((y + 0.5f) * from.Height / Height) - 0.5f, 0, from.Height - 1);
            int y0 = Math.Min((int)fy, from.Height - 2);
            for (int x = 0; x < 3 * Width; x++)
            {
                float fx = Math.Clamp((((x / 3) + 0.5f) * from.Width / Width) - 0.5f, 0, from.Width - 1);
                int x0 = Math.Min((int)fx, from.Width - 2);
                int at = (3 * x0) + (x % 3);
                ReadOnlySpan<float> top = from.Row(y0);
                ReadOnlySpan<float> bottom = from.Row(y0 + 1);
                (float a, float b) = (float.Lerp(top[at], top[at + 3], fx - x0), float.Lerp(bottom[at], bottom[at + 3], fx - x0));
                to.Pixels[(3 * y * Width) + x] = float.Lerp(a, b, fy - y0);
            }
        }

        return to;
    }

    private static int Option(string[] args, string name, int otherwise) =>
        Array.IndexOf(args, name) is >= 0 and var at ? int.Parse(args[at + 1], CultureInfo.InvariantCulture) : otherwise;
}
