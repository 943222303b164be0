using System.Numerics;
using System.Reflection;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Lights;

/// <summary>
/// What holds for every environment: the cases of <see cref="s_cases"/>, of which each type must have one.
/// Covers `EnvironmentLight`.
/// </summary>
[Trait("Category", "Thorough")]
public class EnvironmentTests
{
    private const int Columns = 48, Rows = 24;

    private static readonly IReadOnlyList<TransformDescription> s_turned = [new() { Rotate = 50, Axis = new(1, 2, 0.5f) }];

    // The horizon away from the poles of the tests' grid, where its cells are long.
    private static readonly IReadOnlyList<TransformDescription> s_upright = [new() { Rotate = 75, Axis = new(1, 0, 0) }];

    private static readonly Dictionary<string, EnvironmentDescription> s_cases = new()
    {
        ["constant"] = new ConstantEnvironmentDescription { Radiance = new(2, 1, 0.5f) },
        ["picture"] = new ImageEnvironmentDescription { Picture = Noise(16, 9, 4), Scale = 2 },
        ["turned picture"] = new ImageEnvironmentDescription { Picture = Noise(16, 9, 4), Transform = s_turned },
        ["mirrored picture"] = new ImageEnvironmentDescription { Picture = Noise(7, 6, 2), Transform = [new() { Scale = new(-2, 2, 2), Rotate = 20 }] },
        ["picture with a bright spot"] = new ImageEnvironmentDescription { Picture = Spot(32, 17) },
        ["picture bright at a pole"] = new ImageEnvironmentDescription { Picture = Pole() },
        ["octahedral picture"] = new ImageEnvironmentDescription { Picture = Noise(9, 9, 4), Mapping = DirectionMapping.Octahedral, Transform = s_turned },
        ["picture of one pixel"] = new ImageEnvironmentDescription { Picture = new(1, 1, [1, 2, 3]) },
        ["picture of one row"] = new ImageEnvironmentDescription { Picture = Noise(8, 1, 1) },
        ["sky"] = new SkyEnvironmentDescription { SunSize = 100, SunElevation = 50, Transform = s_turned },
        ["sky without a sun"] = new SkyEnvironmentDescription { SunScale = 0, Turbidity = 6, SunElevation = 5, Transform = s_upright },
    };

    public static TheoryData<string> Cases => [.. s_cases.Keys];

    [Fact]
    public void Every_type_of_environment_has_a_case() => Assert.Equal(
        typeof(EnvironmentDescription).Assembly.GetTypes().Where(t => t.IsSubclassOf(typeof(EnvironmentDescription))).Select(t => t.Name).Order(StringComparer.Ordinal),
        s_cases.Values.Select(c => c.GetType().Name).Distinct().Order(StringComparer.Ordinal));

    [Theory]
    [MemberData(nameof(Cases))]
    public void Directions_are_chosen_with_the_density_that_is_stated(string name)
    {
        EnvironmentLight light = Build(name);
        double[] expected = Integrate(64, (in Vec3W d, out FloatW value) => light.Pdf(d, out value));
        Assert.Equal(1, expected.Sum(), 2e-3);
        int samples = TestSettings.Scale(1 << 16, 1 << 19);
        double[] counts = new double[Columns * Rows];
        UnitSquare.AtRandom(samples, (u, v, lane) =>
        {
            light.Sample(default, u, v, 0f, out ShapeSampleW sample, out _);
            counts[CellOf(Vector3D.Of(sample.Direction, lane))]++;
        });

        // Whose sum is 1 but for the quadrature.
        double sum = expected.Sum();
        ErrorBudget.Lights.Check(PValues.ChiSquared(counts, [.. expected.Select(e => e / sum * samples)]), $"directions of {name}", () => string.Join('\n', counts.Select((c, i) => (c, e: expected[i] / sum * samples, i)).OrderByDescending(x => (x.c - x.e) * (x.c - x.e) / x.e).Take(8)));
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void A_sample_brings_the_radiance_of_its_direction_over_the_density_there(string name)
    {
        EnvironmentLight light = Build(name);
        (int samples, int others) = (0, 0);
        UnitSquare.OnGrid(6, (u, v, lane) =>
        {
            light.Sample(default, u, v, 0f, out ShapeSampleW sample, out RgbW radiance);
            light.Evaluate(sample.Direction, out RgbW there);
            light.Pdf(sample.Direction, out FloatW pdf);
            Assert.Equal(1, Vector3D.Of(sample.Direction, lane).Length, 1e-5);
            Assert.Equal(float.PositiveInfinity, sample.Distance[lane]);
            samples++;

            // On the border of two cells, a rounded direction may lie in the other one.
            bool isSame = Math.Abs((sample.InversePdf[lane] * pdf[lane]) - 1) < 5e-3;
            others += isSame ? 0 : 1;
            double tolerance = (2e-3 * there.G[lane] * sample.InversePdf[lane]) + 1e-5;
            Assert.Equal(there.R[lane] * sample.InversePdf[lane], radiance.R[lane], tolerance);
            Assert.Equal(there.G[lane] * sample.InversePdf[lane], radiance.G[lane], tolerance);
            Assert.Equal(there.B[lane] * sample.InversePdf[lane], radiance.B[lane], 2 * tolerance);
        });
        Assert.InRange(others, 0, samples / 200);
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void The_mean_of_samples_is_the_integral_over_all_directions(string name)
    {
        EnvironmentLight light = Build(name);
        double expected = Integrate(16, (in Vec3W d, out FloatW value) =>
        {
            light.Evaluate(d, out RgbW radiance);
            value = radiance.G;
        }).Sum();
        double mean = 0;
        UnitSquare.OnGrid(9, (u, v, lane) =>
        {
            light.Sample(default, u, v, 0f, out _, out RgbW radiance);
            mean += radiance.G[lane] / (512.0 * 512);
        });
        Assert.Equal(expected, mean, 3e-3 * expected);
    }

    [Fact]
    public void A_grey_picture_brings_nearly_the_same_with_every_sample()
    {
        // But for the rows at the poles, where colours are not linear in the cosine at all.
        Picture picture = Noise(64, 33, 4);
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            picture.Pixels[i] = picture.Pixels[3 * (i / 3)];
        }

        ImageEnvironment light = new(picture, 1, Transform.Identity);
        List<double> values = [];
        UnitSquare.OnGrid(7, (u, v, lane) =>
        {
            light.Sample(default, u, v, 0f, out _, out RgbW radiance);
            values.Add(radiance.G[lane]);
        });
        double mean = values.Average();
        Assert.InRange(Math.Sqrt(values.Average(v => (v - mean) * (v - mean))) / mean, 0, 0.05);
    }

    // As measured in Mitsuba 3: columns have their centres at (i + ½)/W and wrap around, rows lie at j/(H − 1).
    [Fact]
    public void Texels_lie_where_they_do_in_Mitsuba()
    {
        Picture picture = Noise(6, 5, 1);
        ImageEnvironment light = new(picture, 1, Transform.Identity);
        for (int row = 0; row < 5; row++)
        {
            for (int column = 0; column < 6; column++)
            {
                (double u, double v) = ((column + 0.5) / 6, row / 4.0);
                (double sin, double cos) = (Math.Sin(Math.PI * v), Math.Cos(Math.PI * v));
                Vector3 direction = new((float)(sin * Math.Sin(2 * Math.PI * u)), (float)cos, (float)(-sin * Math.Cos(2 * Math.PI * u)));
                light.Evaluate(direction, out RgbW radiance);
                float expected = row is 0 or 4 ? radiance.R[0] : picture.Pixels[3 * ((6 * row) + column)];
                Assert.Equal(expected, radiance.R[0], 1e-5);
            }
        }

        light.Evaluate(new Vector3(0, 0, -1), out RgbW seam);
        Assert.Equal((picture.Pixels[3 * 12] + picture.Pixels[3 * 17]) / 2, seam.R[0], 1e-5);
    }

    [Fact]
    public void A_transform_turns_the_picture()
    {
        EnvironmentLight turned = Build(new ImageEnvironmentDescription { Picture = Noise(16, 9, 4), Transform = [new() { Rotate = 90 }, new() { Translate = new(5, 6, 7) }] });
        EnvironmentLight plain = Build(new ImageEnvironmentDescription { Picture = Noise(16, 9, 4) });
        foreach (Vector3 d in new Vector3[] { new(1, 0, 0), new(0.6f, 0.8f, 0), new(0, -0.6f, 0.8f) })
        {
            // A quarter turn about +y takes x to −z, and z to x.
            turned.Evaluate(new Vector3(d.Z, d.Y, -d.X), out RgbW there);
            plain.Evaluate(d, out RgbW here);
            Assert.Equal(here.G[0], there.G[0], 1e-4);
        }
    }

    [Fact]
    public void A_sun_is_dimmed_by_the_air_and_has_the_same_light_at_every_size()
    {
        SkyEnvironmentDescription sky = new() { Scale = 1, Turbidity = 4, SunScale = 0 };
        double Sun(float elevation, float size)
        {
            SkyEnvironmentDescription d = sky with { SunScale = 1, SunElevation = elevation, SunAzimuth = 90, SunSize = size };
            float radians = elevation * float.Pi / 180;
            Build(d).Evaluate(new Vector3(MathF.Cos(radians), MathF.Sin(radians), 0), out RgbW sun);
            Build(d with { SunScale = 0 }).Evaluate(new Vector3(MathF.Cos(radians), MathF.Sin(radians), 0), out RgbW air);
            double angle = 0.2665 * size * Math.PI / 180;
            return (new Rgb(sun.R[0], sun.G[0], sun.B[0]).Luminance - new Rgb(air.R[0], air.G[0], air.B[0]).Luminance) * 2 * Math.PI * (1 - Math.Cos(angle));
        }

        Assert.InRange(Sun(90, 1), 60, 100);
        Assert.InRange(Sun(5, 1), 0.1, Sun(30, 1) / 3);
        Assert.Equal(Sun(30, 1), Sun(30, 20), 0.02 * Sun(30, 1));
    }

    [Fact]
    public void The_sun_is_chosen_within_its_disk_only()
    {
        EnvironmentLight light = Build(new SkyEnvironmentDescription { SunElevation = 60, SunAzimuth = 0 });
        Vector3D toSun = new(0, Math.Sin(Math.PI / 3), -Math.Cos(Math.PI / 3));
        double rim = 1 - Math.Cos(0.2665 * Math.PI / 180);
        int inside = 0;
        UnitSquare.OnGrid(6, (u, v, lane) =>
        {
            light.Sample(default, u, v, 0f, out ShapeSampleW sample, out _);
            double height = (Vector3D.Of(sample.Direction, lane) - toSun).Squared / 2;
            inside += height <= rim * 1.01 ? 1 : 0;
            Assert.True(sample.InversePdf[lane] > 0.1 || height <= rim * 1.02);
        });
        Assert.InRange(inside / 4096.0, 0.25, 0.76);
    }

    [Fact]
    public void What_rays_see_that_leave_the_scene_is_the_environment()
    {
        foreach (string integrator in new[] { "report", "path" })
        {
            Scene scene = TestScenes.Build($$"""
                { "render": { "width": 4, "height": 4, "samplesPerPixel": 4, "integrator": "{{integrator}}" }, "environment": { "type": "constant", "radiance": [1, 2, 3] } }
                """);
            float[] row = new float[12];
            new RTracer(scene).Render().Film.ReadRow(1, row);
            Assert.Equal([1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3], row);
        }
    }

    private delegate void Density(in Vec3W direction, out FloatW value);

    // The integral over each cell of a grid of directions, by so many points a side, evenly over its solid angle.
    private static double[] Integrate(int side, Density density)
    {
        double[] integrals = new double[Columns * Rows];
        double share = 4 * Math.PI / (Columns * Rows * side * side);
        for (int y = 0; y < Rows * side; y++)
        {
            double height = 1 - (2 * (y + 0.5) / (Rows * side));
            float radius = (float)Math.Sqrt(1 - (height * height));
            for (int x = 0; x < Columns * side; x += FloatW.Count)
            {
                LaneMath.SinCosTurn((UIntW.Iota + (uint)x).ToFloat() * (1f / (Columns * side)) + (0.5f / (Columns * side)), out FloatW sin, out FloatW cos);
                density(new Vec3W(sin * radius, cos * radius, (float)height), out FloatW value);
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    integrals[(y / side * Columns) + ((x + lane) / side)] += value[lane] * share;
                }
            }
        }

        return integrals;
    }

    private static int CellOf(Vector3D d)
    {
        double turn = Math.Atan2(d.X, d.Y) / (2 * Math.PI);
        int column = (int)(Columns * (turn < 0 ? turn + 1 : turn));
        int row = (int)(Rows * (1 - d.Z) / 2);
        return (Math.Clamp(row, 0, Rows - 1) * Columns) + Math.Min(column, Columns - 1);
    }

    private static EnvironmentLight Build(string name) => Build(s_cases[name]);

    private static EnvironmentLight Build(EnvironmentDescription description)
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        return description.Build(builder) ?? throw new InvalidOperationException(string.Join('\n', builder.Complaints.Select(c => c.Message)));
    }

    private static Picture Noise(int width, int height, double contrast)
    {
        Random random = new(5);
        return new(width, height, [.. Enumerable.Range(0, 3 * width * height).Select(_ => (float)Math.Pow(random.NextDouble(), contrast))]);
    }

    private static Picture Spot(int width, int height)
    {
        Picture picture = Noise(width, height, 1);
        for (int i = 0; i < 3; i++)
        {
            picture.Pixels[(3 * ((width * 4) + 9)) + i] = 1000;
        }

        return picture;
    }

    private static Picture Pole()
    {
        Picture picture = new(8, 5);
        picture.Pixels.AsSpan(0, 24).Fill(7);
        return picture;
    }
}
