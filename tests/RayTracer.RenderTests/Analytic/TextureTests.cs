using System.Numerics;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.RenderTests.Analytic;

/// <summary>Textures against their formulas in double precision, and rendered: pictures whose texels fall on pixels.</summary>
public sealed class TextureTests : IDisposable
{
    private const int Width = 6;
    private const int Height = 4;

    // Every texel is another one: no mirroring or shift gives the same picture.
    private static readonly Picture s_picture = new(Width, Height, [.. Enumerable.Range(0, 3 * Width * Height).Select(i => (1 + (i * 7 % 73)) / 73f)]);

    private readonly string _folder = Directory.CreateTempSubdirectory("raytracer-").FullName;

    public TextureTests() => ImageFile.Write(Path.Combine(_folder, "the.pfm"), s_picture);

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData(Interpolation.Nearest)]
    [InlineData(Interpolation.Bilinear)]
    [InlineData(Interpolation.Bicubic)]
    public void Every_interpolation_and_wrapping_is_its_formula_anywhere(Interpolation interpolation)
    {
        Random random = new(TestSettings.Seed);
        foreach (Wrapping wrapping in Enum.GetValues<Wrapping>())
        {
            ImageTexture texture = new(s_picture, interpolation, wrapping, new(1.5f, -0.75f), new(0.25f, 0.5f));
            for (int i = 0; i < 2000; i++)
            {
                (float u, float v) = ((random.NextSingle() * 8) - 4, (random.NextSingle() * 8) - 4);
                texture.Evaluate(u, v, out RgbW color);
                double x = ((u * 1.5) + 0.25) * Width;
                double y = (1 - ((v * -0.75) + 0.5)) * Height;
                if (interpolation == Interpolation.Nearest && (IsBetweenTexels(x) || IsBetweenTexels(y)))
                {
                    continue;
                }

                Assert.Equal(Expected(interpolation, wrapping, x, y, 0), color.R[0], 2e-5);
                Assert.Equal(Expected(interpolation, wrapping, x, y, 1), color.G[0], 2e-5);
                Assert.Equal(Expected(interpolation, wrapping, x, y, 2), color.B[0], 2e-5);
            }
        }

        static bool IsBetweenTexels(double x) => Math.Abs(x - Math.Round(x)) < 1e-4;
    }

    [Fact]
    public void A_checker_is_even_where_the_whole_parts_of_scaled_uv_add_up_to_an_even_number()
    {
        CheckerTexture texture = new(new SolidTexture(Rgb.White), new SolidTexture(Rgb.Black), new(3, -2), new(0.5f, 0.25f));
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 2000; i++)
        {
            (float u, float v) = ((random.NextSingle() * 8) - 4, (random.NextSingle() * 8) - 4);
            (double x, double y) = ((u * 3.0) + 0.5, (v * -2.0) + 0.25);
            if (Math.Abs(x - Math.Round(x)) > 1e-4 && Math.Abs(y - Math.Round(y)) > 1e-4)
            {
                texture.Evaluate(u, v, out RgbW color);
                Assert.Equal(((long)Math.Floor(x) + (long)Math.Floor(y)) % 2 == 0 ? 1 : 0, color.G[0]);
            }
        }
    }

    [Theory]
    [InlineData("plane", "luminaire")]
    [InlineData("triangles", "luminaire")]
    [InlineData("plane", "diffuse")]
    [InlineData("triangles", "diffuse")]
    [InlineData("plane", "phongMetal")]
    [InlineData("plane", "varnish")]
    public void A_picture_on_a_rectangle_that_fills_the_image_is_the_image(string shape, string material)
    {
        string color = "\"color\": { \"type\": \"image\", \"file\": \"the.pfm\", \"interpolation\": \"nearest\" }";
        string look = material switch
        {
            // All of them answer ambient light of 1 by their colour; there is no bounce.
            "luminaire" => $$"""{ "type": "luminaire", {{color}} }""",
            "varnish" => $$"""{ "type": "diffuseSpecular", "r0": 0, "diffuse": { "type": "diffuse", {{color}} } }""",
            _ => $$"""{ "type": "{{material}}", {{color}} }""",
        };
        string shapes = shape == "plane"
            ? $$"""{ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "size": [6, 4], "material": {{look}} }"""
            : $$"""
              { "type": "triangle", "a": [3, -2, 0], "b": [3, 2, 0], "c": [-3, -2, 0], "uvA": [1, 0], "uvB": [1, 1], "uvC": [0, 0], "material": {{look}} },
              { "type": "triangle", "a": [-3, 2, 0], "b": [-3, -2, 0], "c": [3, 2, 0], "uvA": [0, 1], "uvB": [0, 0], "uvC": [1, 1], "material": {{look}} }
              """;
        Film film = Render($$"""
            { "camera": { "position": [0, 0, 400], "lookAt": [0, 0, 0], "fieldOfView": {{2 * Math.Atan(2.0 / 400) * 180 / Math.PI}} },
              "render": { "integrator": "report", "width": {{Width}}, "height": {{Height}}, "samplesPerPixel": 16, "sampler": "regular", "maxDiffuseDepth": 0, "maxSpecularDepth": 0 },
              "ambient": [1, 1, 1], "shapes": [ {{shapes}} ] }
            """);
        for (int i = 0; i < Width * Height; i++)
        {
            Rgb expected = new(s_picture.Pixels[3 * i], s_picture.Pixels[(3 * i) + 1], s_picture.Pixels[(3 * i) + 2]);
            Rgb seen = film.Mean(i % Width, i / Width);

            // Straight ahead but for half a degree, varnish with no r0 reflects nothing.
            Assert.Equal(expected.R, seen.R, 1e-6f);
            Assert.Equal(expected.G, seen.G, 1e-6f);
            Assert.Equal(expected.B, seen.B, 1e-6f);
        }
    }

    [Fact]
    public void A_plane_without_end_shows_a_picture_a_unit_wide_from_its_point_on()
    {
        // On a floor, u is to the right and v away from the viewer. The image is the square unit of u from 2 and v from 7.
        const int edge = 12;
        Film film = Render($$"""
            { "camera": { "position": [3.5, 400, -7.5], "lookAt": [3.5, 0, -7.5], "up": [0, 0, -1], "fieldOfView": {{2 * Math.Atan(0.5 / 400) * 180 / Math.PI}} },
              "render": { "integrator": "report", "width": {{edge}}, "height": {{edge}}, "samplesPerPixel": 16, "sampler": "regular", "maxDiffuseDepth": 0, "maxSpecularDepth": 0 },
              "ambient": [1, 1, 1],
              "shapes": [ { "type": "plane", "point": [1, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "image", "file": "the.pfm", "interpolation": "nearest" } } } ] }
            """);
        for (int i = 0; i < edge * edge; i++)
        {
            int texel = (i / edge * Height / edge * Width) + (i % edge * Width / edge);
            Assert.Equal(s_picture.Pixels[3 * texel], film.Mean(i % edge, i / edge).R, 1e-6f);
        }
    }

    [Fact]
    public void On_a_sphere_u_goes_once_around_from_the_back_and_v_from_pole_to_pole()
    {
        for (int i = 0; i < Width * Height; i++)
        {
            // The middle of a texel: longitude from −z over −x to +z, latitude from the top row.
            double longitude = 2 * Math.PI * (((i % Width) + 0.5) / Width - 0.5);
            double latitude = Math.PI * (0.5 - (((i / Width) + 0.5) / Height));
            Vec3D normal = new(Math.Sin(longitude) * Math.Cos(latitude), Math.Sin(latitude), Math.Cos(longitude) * Math.Cos(latitude));
            Film film = Render($$"""
                { "camera": { "position": {{(normal * 5) + new Vec3D(1, 2, 3)}}, "lookAt": [1, 2, 3], "fieldOfView": 1 },
                  "render": { "integrator": "report", "width": 1, "height": 1, "samplesPerPixel": 4, "maxDiffuseDepth": 0 }, "ambient": [1, 1, 1],
                  "shapes": [ { "type": "sphere", "center": [1, 2, 3], "radius": 0.5, "material": { "type": "diffuse", "color": { "type": "image", "file": "the.pfm", "interpolation": "nearest" } } } ] }
                """);
            Assert.Equal(s_picture.Pixels[3 * i], film.Mean(0, 0).R, 1e-6f);
        }
    }

    // Bilinear: a tent; bicubic: the cubic through four points of Catmull and Rom, by its derivatives (Keys 1981).
    private static double Expected(Interpolation interpolation, Wrapping wrapping, double x, double y, int channel)
    {
        if (interpolation == Interpolation.Nearest)
        {
            return Texel((int)Math.Floor(x), (int)Math.Floor(y));
        }

        (int left, int top) = ((int)Math.Floor(x - 0.5), (int)Math.Floor(y - 0.5));
        (double fx, double fy) = (x - 0.5 - left, y - 0.5 - top);
        if (interpolation == Interpolation.Bilinear)
        {
            return ((1 - fy) * (((1 - fx) * Texel(left, top)) + (fx * Texel(left + 1, top))))
                + (fy * (((1 - fx) * Texel(left, top + 1)) + (fx * Texel(left + 1, top + 1))));
        }

        double[] rows = [.. Enumerable.Range(top - 1, 4).Select(row => Spline(Texel(left - 1, row), Texel(left, row), Texel(left + 1, row), Texel(left + 2, row), fx))];
        return Math.Max(0, Spline(rows[0], rows[1], rows[2], rows[3], fy));

        double Texel(int column, int row) => s_picture.Pixels[(3 * ((Wrap(row, Height) * Width) + Wrap(column, Width))) + channel];

        int Wrap(int i, int n) => wrapping switch
        {
            Wrapping.Repeat => ((i % n) + n) % n,
            Wrapping.Clamp => Math.Clamp(i, 0, n - 1),
            _ => (((i % (2 * n)) + (2 * n)) % (2 * n)) is var inPair && inPair < n ? inPair : (2 * n) - 1 - inPair,
        };
    }

    // The cubic from b to c whose slopes are those of the chords around them.
    private static double Spline(double a, double b, double c, double d, double t)
    {
        (double slopeB, double slopeC) = ((c - a) / 2, (d - b) / 2);
        return ((1 + (2 * t)) * (1 - t) * (1 - t) * b) + (t * (1 - t) * (1 - t) * slopeB) + (t * t * (3 - (2 * t)) * c) + (t * t * (t - 1) * slopeC);
    }

    private Film Render(string json)
    {
        SceneLoadResult result = SceneLoader.Build(SceneReader.ReadText(json, "test.json"), _folder);
        return new RTracer(result.Scene ?? throw new InvalidOperationException(Diagnostic.Format(result.Diagnostics))).Render().Film;
    }
}
