using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Testing;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

[Trait("Category", "Thorough")]
public class DenoiserTests
{
    [Fact]
    public void Noise_becomes_a_fraction_of_what_it_was_and_edges_stay()
    {
        // The scene of the report: textured floor, glass, mirrors. Against a converged reference.
        int size = TestSettings.Scale(96, 200);
        Scene noisy = Report(size, 16, 1);
        HalfRender[] halves = Halves(noisy);
        Film raw = new(size, size);
        raw.Merge(halves[0].Film);
        raw.Merge(halves[1].Film);
        Film reference = new RTracer(Report(size, TestSettings.Scale(400, 1600), 2)).Render().Film;
        DenoiseResult denoised = Denoiser.Denoise(halves[0], halves[1]);
        double before = Error(raw, reference);
        double after = Error(denoised.Picture, reference);
        Assert.InRange(after / before, 0, 0.4);
        Assert.InRange(denoised.CutShare, 0, 0.02);
        Assert.Equal((1 - denoised.CutShare) * Mean(raw), Mean(denoised.Picture), 0.01 * Mean(raw));
    }

    [Fact]
    public void A_coat_over_a_dark_pattern_keeps_its_colour()
    {
        // The coat's light is white, and most of what comes back: stripes whose blue is nearly black must not make it blue.
        Scene Coated(int samples, long seed) => TestScenes.Build($$"""
            { "render": { "width": 64, "height": 40, "samplesPerPixel": {{samples}}, "seed": {{seed + (100L * TestSettings.Seed)}}, "integrator": "path" },
              "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0] }, "background": [0.5, 0.5, 0.5],
              "shapes": [{ "type": "box", "a": [-3, -2, -1], "b": [3, 2, 0], "material": { "type": "principled", "roughness": 0.4, "clearcoat": 0.6,
                "baseColor": { "type": "checker", "even": [0.16, 0.08, 0.04], "odd": [0.08, 0.035, 0.018], "scale": [6, 6] } } }],
              "lights": [{ "type": "sphere", "center": [2, 2, 5], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 8 } }] }
            """);
        HalfRender[] halves = Halves(Coated(16, 1));
        Film raw = new(64, 40);
        raw.Merge(halves[0].Film);
        raw.Merge(halves[1].Film);
        Film reference = new RTracer(Coated(1024, 2)).Render().Film;
        Assert.InRange(Error(Denoiser.Denoise(halves[0], halves[1]).Picture, reference) / Error(raw, reference), 0, 0.4);
    }

    // What fog hides are a horizon and a board of chess: neither is to be seen in it once noise is gone.
    [Fact]
    public void Dense_fog_shows_nothing_of_what_is_behind_it()
    {
        Scene Hidden(int samples, long seed) => TestScenes.Build($$"""
            { "render": { "width": 72, "height": 48, "samplesPerPixel": {{samples}}, "seed": {{seed + (100L * TestSettings.Seed)}}, "integrator": "volPath" },
              "camera": { "position": [0, 1.2, 6], "lookAt": [0, 1.2, 0], "fieldOfView": 18 }, "background": [0.55, 0.65, 0.8],
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse",
                    "color": { "type": "checker", "even": [0.6, 0.3, 0.1], "odd": [0.1, 0.2, 0.1], "scale": [1, 1] } } },
                { "type": "box", "a": [-4, 0.1, -1], "b": [4, 3, 1], "material": { "type": "invisible", "interior": { "extinction": [5, 5, 5], "albedo": [0.9, 0.9, 0.9] } } }],
              "lights": [{ "type": "sphere", "center": [3, 5, 6], "radius": 0.7, "material": { "type": "luminaire", "multiplier": 18 } }] }
            """);
        HalfRender[] halves = Halves(Hidden(16, 1));
        Film raw = new(72, 48);
        raw.Merge(halves[0].Film);
        raw.Merge(halves[1].Film);
        Film reference = new RTracer(Hidden(1024, 2)).Render().Film;
        Assert.InRange(Error(Denoiser.Denoise(halves[0], halves[1]).Picture, reference) / Error(raw, reference), 0, 0.04);
    }

    [Theory]
    [InlineData(4)]
    [InlineData(30)]
    [InlineData(1000)]
    public void Bright_spots_have_no_black_beside_them(float spot)
    {
        Random random = new(TestSettings.Seed + 3);
        Picture noisy = new(48, 40);
        for (int i = 0; i < noisy.Pixels.Length; i++)
        {
            noisy.Pixels[i] = 0.8f + (0.2f * random.NextSingle());
        }

        foreach ((int x, int y) in new[] { (11, 12), (24, 19), (37, 30) })
        {
            noisy.Pixels.AsSpan(3 * ((y * 48) + x), 3).Fill(spot);
        }

        Picture denoised = Denoiser.Denoise(noisy, null, null);
        Assert.All(denoised.Pixels, p => Assert.True(p > 0.35f, $"{p}"));
    }

    [Fact]
    public void Two_halves_make_the_film_of_one_go_to_the_bit()
    {
        Scene scene = TestScenes.BuildEverything();
        HalfRender[] halves = Halves(scene);
        Film merged = new(scene.Render.Width, scene.Render.Height);
        merged.Merge(halves[1].Film);
        merged.Merge(halves[0].Film);
        Assert.Equal(new RTracer(scene).Render().Film.ComputeHash(), merged.ComputeHash());
    }

    [Fact]
    public void What_has_no_noise_is_unchanged_to_the_bit()
    {
        Scene scene = TestScenes.Build("""
            { "background": [0.3, 0.7, 0.123], "render": { "integrator": "report", "width": 37, "height": 21, "samplesPerPixel": 6 }, "shapes": [{ "type": "sphere", "center": [0, 0, 99] }] }
            """);
        HalfRender[] halves = Halves(scene);
        Picture denoised = Denoiser.Denoise(halves[0], halves[1]).Picture;
        for (int i = 0; i < denoised.Pixels.Length; i++)
        {
            Assert.Equal(halves[0].Film.Mean(0, 0) is var c ? (i % 3) switch { 0 => c.R, 1 => c.G, _ => c.B } : 0, denoised.Pixels[i]);
        }
    }

    [Fact]
    public void A_firefly_of_one_half_is_cut_and_named()
    {
        Scene scene = Lit();
        HalfRender[] halves = Halves(scene);
        Picture without = Denoiser.Denoise(halves[0], halves[1]).Picture;
        AddLight(halves[0], 20, 12, 4000);
        DenoiseResult with = Denoiser.Denoise(halves[0], halves[1]);
        Assert.InRange(ImageComparison.Compare(with.Picture, without).Rmse, 0, 0.02);
        Assert.InRange(with.CutShare, 0.5, 1);
    }

    [Fact]
    public void A_bright_spot_that_both_halves_have_stays()
    {
        HalfRender[] halves = Halves(Lit());
        AddLight(halves[0], 20, 12, 4000);
        AddLight(halves[1], 20, 12, 4000);
        DenoiseResult result = Denoiser.Denoise(halves[0], halves[1]);
        Assert.Equal(halves[0].Film.Mean(20, 12).R, result.Picture.Pixels[3 * ((12 * 40) + 20)], 1f);
        Assert.InRange(result.CutShare, 0, 0.01);
    }

    [Fact]
    public void Threads_change_no_bit()
    {
        HalfRender[] halves = Halves(TestScenes.BuildEverything());
        float[] one = Denoiser.Denoise(halves[0], halves[1], 1).Picture.Pixels;
        Assert.All(one, p => Assert.True(float.IsFinite(p)));
        Assert.Equal(one, Denoiser.Denoise(halves[0], halves[1], 2).Picture.Pixels);
        Assert.Equal(one, Denoiser.Denoise(halves[0], halves[1], 7).Picture.Pixels);
    }

    [Fact]
    public void A_crop_is_denoised_and_the_rest_stays_black()
    {
        Scene scene = TestScenes.BuildEverything();
        HalfRender[] halves = Halves(scene, new(10, 5, 20, 15));
        Picture denoised = Denoiser.Denoise(halves[0], halves[1]).Picture;
        for (int y = 0; y < denoised.Height; y++)
        {
            for (int x = 0; x < denoised.Width; x++)
            {
                float green = denoised.Pixels[(3 * ((y * denoised.Width) + x)) + 1];
                Assert.Equal(x is >= 10 and < 30 && y is >= 5 and < 20, green > 0);
            }
        }
    }

    [Fact]
    public void Halves_of_different_sizes_are_refused() =>
        Assert.Throws<ArgumentException>(() => Denoiser.Denoise(HalfRender.Create(4, 3), HalfRender.Create(4, 4)));

    private static Scene Report(int size, int samples, long seed) => SceneRuns.Load(ProjectFolder.PathOf("scenes", "report", "scene1.json"), d => d with
    {
        Render = d.Render with { Width = size, Height = size, SamplesPerPixel = samples, Seed = seed + (100L * TestSettings.Seed) },
    });

    private static HalfRender[] Halves(Scene scene, Tile? crop = null)
    {
        (int width, int height, int count) = (scene.Render.Width, scene.Render.Height, scene.Render.SamplesPerPixel);
        SampleRange[] ranges = [new(0, count / 2), new(count / 2, count)];
        return [.. ranges.Select(range =>
        {
            HalfRender half = HalfRender.Create(width, height);
            RenderOptions options = new() { Samples = range, Crop = crop };
            new RTracer(scene, options).Render(half.Film);
            HalfRender.Pass(scene, options).Render(half.Features);
            return half;
        })];
    }

    private static Scene Lit() => TestScenes.Build("""
        { "render": { "width": 40, "height": 30, "samplesPerPixel": 8, "integrator": "path" }, "shapes": [
          { "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0] },
          { "type": "sphere", "center": [0, 4, 3], "material": { "type": "luminaire", "multiplier": 9 } }] }
        """);

    private static void AddLight(HalfRender half, int x, int y, int amount)
    {
        Int128[] sums = new Int128[4 * half.Film.Width];
        sums.AsSpan(4 * x, 3).Fill((Int128)amount << 32);
        half.Film.AddSums(y, sums, new uint[half.Film.Width]);
    }

    // Mean squared error relative to the reference's brightness.
    private static double Error(IImageRows image, Film reference)
    {
        float[] row = new float[3 * reference.Width];
        double sum = 0;
        for (int y = 0; y < reference.Height; y++)
        {
            image.ReadRow(y, row);
            for (int x = 0; x < reference.Width; x++)
            {
                Rgb r = reference.Mean(x, y);
                Rgb d = new(row[3 * x] - r.R, row[(3 * x) + 1] - r.G, row[(3 * x) + 2] - r.B);
                sum += ((d.R * d.R) + (d.G * d.G) + (d.B * d.B)) / (0.01 + (r.Luminance * r.Luminance));
            }
        }

        return sum / (reference.Width * reference.Height);
    }

    private static double Mean(IImageRows image)
    {
        float[] row = new float[3 * image.Width];
        double sum = 0;
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            sum += row.Sum(v => (double)v);
        }

        return sum / (3.0 * image.Width * image.Height);
    }
}
