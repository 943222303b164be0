using RayTracer.Imaging;
using RayTracer.Textbook;
using RayTracer.Textures;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Study;

/// <summary>One small scene by the two ways to find what is visible: plates that cross over a floor, with a lamp at a point.</summary>
internal static class TwoWays
{
    private const int Width = 480;
    private const int Height = 320;
    private const double PixelSize = 1.0 / 480;
    private static readonly Vector s_eye = new(0.4, 1.7, 4.6);
    private static readonly Vector s_forward = new Vector(-0.08, -0.22, -1).Unit;
    private static readonly Vector s_right = Vector.Cross(s_forward, new(0, 1, 0)).Unit;
    private static readonly Vector s_up = Vector.Cross(s_right, s_forward);
    private static readonly Vector s_lamp = new(-1.2, 3.6, 2.2);
    private static readonly Rgb s_power = new(34, 32, 29);
    private static readonly Rgb s_ambient = new(0.12, 0.13, 0.15);

    private static readonly Face[] s_floor =
        [new(new(-6, 0, 4), new(6, 0, 4), new(6, 0, -6), new(0.55, 0.55, 0.5)), new(new(-6, 0, 4), new(6, 0, -6), new(-6, 0, -6), new(0.55, 0.55, 0.5))];

    // Two plates that cross, and three that hide each other in a circle.
    private static readonly Face[] s_things =
    [
        new(new(-1.9, 0.2, 0.2), new(-0.3, 0.2, 0.9), new(-1.1, 1.7, 0.5), new(0.8, 0.3, 0.2)),
        new(new(-1.9, 0.3, 1.0), new(-0.2, 0.5, 0.1), new(-1.0, 1.5, 0.6), new(0.2, 0.5, 0.8)),
        new(new(1.41, 1.67, 0.6), new(0.99, 1.91, 0.6), new(0.39, 0.39, -0.3), new(0.85, 0.7, 0.2)),
        new(new(0.36, 0.93, 0.6), new(0.36, 0.45, 0.6), new(1.99, 0.69, -0.3), new(0.3, 0.7, 0.35)),
        new(new(1.53, 0.40, 0.6), new(1.94, 0.64, 0.6), new(0.93, 1.92, -0.3), new(0.6, 0.35, 0.7)),
    ];

    /// <summary>The pictures, with their files and captions.</summary>
    public static IReadOnlyList<(string File, string Caption, Func<Picture> Make)> Pictures { get; } =
    [
        ("visible-z-buffer.png", "By a z-buffer, with shadows that are pressed onto the floor (Blinn 1988)", () => Raster(isPainter: false)),
        ("visible-painter.png", "By the painter's algorithm: wrong where plates cross, or hide each other in a circle", () => Raster(isPainter: true)),
        ("visible-rays.png", "By rays, as Whitted traced them: the plates throw shadows on each other too", Rays),
    ];

    private static Picture Raster(bool isPainter)
    {
        Matrix camera = Matrix.Perspective(Width * PixelSize, Height * PixelSize, 0.1, 100).After(Matrix.View(s_eye, s_right, s_up, s_forward));
        Homogeneous lamp = new(s_lamp.X, s_lamp.Y, s_lamp.Z, 1);
        Rasterizer raster = new(Width, Height) { IsPainter = isPainter, Lights = [new(lamp, s_power)], Ambient = s_ambient };

        // In order: the floor, its shadows, which have its ambient light alone, and the things.
        raster.Draw([.. s_floor.SelectMany(f => Finer(f, 5))], camera);
        Rasterizer shade = new(Width, Height) { IsPainter = isPainter };
        Face[] shadows = [.. ProjectedShadow.Of(s_things, new(0, 1, 0), 0, lamp, lift: 1e-3)];
        shade.Draw(shadows, camera);
        Rgb dark = s_floor[0].Color * s_ambient;
        for (int i = 0; i < raster.Pixels.Length; i++)
        {
            raster.Pixels[i] = shade.Visible[i] >= 0 ? dark : raster.Pixels[i];
        }

        raster.Draw([.. s_things.Select(Towards)], camera);
        return PictureOf(raster.Pixels);
    }

    private static Picture Rays()
    {
        PerspectiveCamera camera = new(s_eye, s_forward, s_right, s_up, Width, Height, PixelSize, new Pinhole(), 1);
        Face[] all = [.. s_floor, .. s_things];
        Scene scene = new(camera, all.Select(f => new Thing(new Triangle(f.A, f.B, f.C, default), new Diffuse(new Solid(f.Color)))), [new PointLight(s_lamp, s_power)], null, s_ambient);
        WhittedIntegrator integrator = new(0);
        IndependentSampler sampler = new();
        return PictureOf([.. Enumerable.Range(0, Width * Height)
            .Select(i => integrator.Radiance(scene, camera.RayThrough((i % Width) + 0.5, (i / Width) + 0.5, sampler), sampler))]);
    }

    // Light is computed at corners: large triangles would miss what is bright between them.
    private static IEnumerable<Face> Finer(Face f, int levels)
    {
        (Vector ab, Vector bc, Vector ca) = (0.5 * (f.A + f.B), 0.5 * (f.B + f.C), 0.5 * (f.C + f.A));
        return levels == 0 ? [f] : new[] { f with { B = ab, C = ca }, f with { A = ab, C = bc }, f with { A = ca, B = bc }, f with { A = ab, B = bc, C = ca } }.SelectMany(part => Finer(part, levels - 1));
    }

    // The side that the eye sees.
    private static Face Towards(Face f) => Vector.Dot(f.Normal, s_eye - f.A) > 0 ? f : f with { B = f.C, C = f.B };

    private static Picture PictureOf(Rgb[] pixels)
    {
        Picture picture = new(Width, Height);
        for (int i = 0; i < pixels.Length; i++)
        {
            (picture.Pixels[3 * i], picture.Pixels[(3 * i) + 1], picture.Pixels[(3 * i) + 2]) = ((float)pixels[i].R, (float)pixels[i].G, (float)pixels[i].B);
        }

        return picture;
    }
}
