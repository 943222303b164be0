using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.RenderTests.Analytic;

/// <summary>
/// Fresnel's equations, Snell's law, total reflection and Beer's law for the materials of the report's table 4.1. The
/// expected reflectances are computed from the angles (Born &amp; Wolf 1999, section 1.5.2, eq. 21), not, as in the product, from cosines.
/// </summary>
[Trait("Category", "Thorough")]
public class GlassTests
{
    /// <summary>The report's table 4.1, "Sample indices of refraction".</summary>
    public static TheoryData<string, double> Table() => new()
    {
        { "amber", 1.54 }, { "cubic zirconia", 2.15 }, { "diamond", 2.417 }, { "emerald", 1.57 }, { "fused quartz", 1.46 },
        { "garnet, low", 1.73 }, { "garnet, high", 1.89 }, { "glass", 1.5 }, { "ice", 1.309 }, { "ruby", 1.77 }, { "sapphire", 1.77 },
        { "sodium chloride", 1.53 }, { "water", 1.333 },
    };

    [Theory]
    [MemberData(nameof(Table))]
    public void Reflectance_and_direction_are_Fresnels_and_Snells_at_every_angle_from_both_sides(string name, double index)
    {
        Material material = new DielectricMaterial((float)index, Rgb.Black, FresnelModel.Exact);
        foreach (bool inside in new[] { false, true })
        {
            double relative = inside ? 1 / index : index;
            for (int degrees = 1; degrees < 90; degrees += 4)
            {
                double angle = degrees * Math.PI / 180;
                double sine = Math.Sin(angle) / relative;
                double reflectance = Reflectance(angle, relative);
                int reflected = 0;
                Scatter(material, angle, inside, (direction, weight) =>
                {
                    // The normal is z, the plane of incidence that of x and z.
                    bool isReflection = direction.Z > 0;
                    reflected += isReflection ? 1 : 0;
                    Assert.Equal(isReflection ? Math.Sin(angle) : sine, direction.X, 2e-6);
                    Assert.Equal(0, direction.Y, 1e-6);
                    Assert.Equal(isReflection ? 1 : 1 / (relative * relative), weight, 1e-5);
                });

                // A net's coordinates are one in each of its intervals: the count is right but for one.
                Assert.True(
                    Math.Abs(reflected - (reflectance * Count)) <= 1.01,
                    FormattableString.Invariant($"{name} at {degrees}°, {(inside ? "inside" : "outside")}: {reflected} of {Count} are reflected instead of {reflectance * Count:F1}"));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Table))]
    public void Half_spaces_reflect_and_transmit_what_Fresnel_says(string name, double index)
    {
        double brewster = Math.Atan(index);
        foreach (double angle in new[] { 0.1, brewster, 1.3 })
        {
            double reflectance = Reflectance(angle, index);
            Closed.Check(
                FormattableString.Invariant($"{name}, seen from outside at {angle} rad"),
                HalfSpace(index, angle, below: false),
                (_, _, channel) => channel switch { 0 => reflectance, 1 => (1 - reflectance) / (index * index), _ => 0 },
                tolerance: OneSample);
        }

        // At Brewster's angle (Born & Wolf 1999, section 1.5.3) only light across the plane of incidence is reflected.
        double across = ((index * index) - 1) / ((index * index) + 1);
        Assert.Equal(across * across / 2, Reflectance(brewster, index), 12);
    }

    [Theory]
    [MemberData(nameof(Table))]
    public void Within_glass_nothing_leaves_beyond_the_critical_angle(string name, double index)
    {
        double critical = Math.Asin(1 / index);
        foreach (double angle in new[] { critical - 0.02, critical + 0.001, 1.4 })
        {
            double reflectance = Reflectance(angle, 1 / index);
            Assert.Equal(angle > critical, reflectance == 1);
            Closed.Check(
                FormattableString.Invariant($"{name}, seen from inside at {angle} rad"),
                HalfSpace(index, angle, below: true),
                (_, _, channel) => channel switch { 0 => (1 - reflectance) * index * index, 1 => reflectance, _ => 0 },
                tolerance: OneSample * index * index);
        }
    }

    [Theory]
    [MemberData(nameof(Table))]
    public void What_lies_in_a_pool_is_seen_where_Snells_law_puts_it(string name, double index)
    {
        // The bottom, 1 below, shines to the right of a line. The eye's ray meets the surface at x = 0.
        double angle = 1.1;
        double x = Math.Tan(Math.Asin(Math.Sin(angle) / index));
        foreach (double side in new[] { -1e-3, 1e-3 })
        {
            (double sin, double cos) = Math.SinCos(angle);
            ImageSamples images = SceneRuns.RenderText(
                $$"""
                { "camera": { "position": {{new Vec3D(-5 * sin, 5 * cos, 0)}}, "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
                  "render": { "integrator": "report", "width": 1, "height": 1, "samplesPerPixel": {{Samples}} },
                  "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "dielectric", "refractiveIndex": {{index}} } },
                    { "type": "plane", "point": {{new Vec3D(x + side + 5, -1, 0)}}, "normal": [0, 1, 0], "size": [10, 10], "material": { "type": "luminaire" } } ] }
                """,
                TestSettings.Scale(4, 32));
            double seen = side > 0 ? 0 : (1 - Reflectance(angle, index)) / (index * index);
            Closed.Check(FormattableString.Invariant($"pool of {name}, edge at {side}"), images, (_, _, _) => seen, tolerance: OneSample);
        }
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(0.6)]
    [InlineData(0.95)]
    public void A_coloured_ball_of_index_1_absorbs_by_Beers_law_along_its_chord(double distance)
    {
        double chord = 2 * 2 * Math.Sqrt(1 - (distance * distance));
        ImageSamples images = Ball(1, distance, "[0.1, 0.5, 2]", 4);

        // Inside, the ray starts 2⁻¹⁸ of the ball's size off its surface.
        Closed.Check($"Beer's law at {distance}", images, (_, _, channel) => Math.Exp(-chord * s_extinction[channel]), tolerance: 1e-5);
    }

    [Theory]
    [InlineData(1.5, 0.0, 1)]
    [InlineData(1.5, 0.0, 2)]
    [InlineData(1.5, 0.8, 2)]
    [InlineData(1.5, 0.8, 3)]
    [InlineData(2.417, 0.6, 5)]
    [InlineData(2.417, 0.95, 40)]
    [InlineData(1.333, 0.5, 40)]
    public void A_coloured_glass_ball_sends_back_a_series_of_internal_reflections(double index, double distance, int depth)
    {
        // All chords of a ray in a ball are alike, and so are all angles; it takes two of the specular bounces to get in and out.
        double angle = Math.Asin(distance);
        double refracted = Math.Asin(distance / index);
        double r = Reflectance(angle, index);
        Closed.Check(FormattableString.Invariant($"ball of index {index} at {distance}, {depth} bounces"), Ball(index, distance, "[0.1, 0.5, 2]", depth), (_, _, channel) =>
        {
            double passed = Math.Exp(-s_extinction[channel] * 4 * Math.Cos(refracted));
            double sum = r;
            for (int k = 0; k + 2 <= depth; k++)
            {
                sum += (1 - r) * (1 - r) * passed * Math.Pow(r * passed, k);
            }

            return sum;
        }, tolerance: OneSample);
    }

    [Fact]
    public void Schlicks_approximation_is_what_it_says()
    {
        // Schlick 1994, eq. 24, from outside; from inside, with the cosine on the side of the air.
        Material material = new DielectricMaterial(1.5f, Rgb.Black, FresnelModel.Schlick);
        foreach (bool inside in new[] { false, true })
        {
            for (int degrees = 1; degrees < (inside ? 41 : 90); degrees += 4)
            {
                double angle = degrees * Math.PI / 180;
                double inAir = inside ? Math.Asin(1.5 * Math.Sin(angle)) : angle;
                double expected = 0.04 + (0.96 * Math.Pow(1 - Math.Cos(inAir), 5));
                int reflected = 0;
                Scatter(material, angle, inside, (direction, _) => reflected += direction.Z > 0 ? 1 : 0);
                Assert.InRange(reflected, (expected * Count) - 1.01, (expected * Count) + 1.01);
            }
        }
    }

    private const int Count = 4096;

    // The points of a net are so even that nearly every seed may reflect the same number of a pixel's paths.
    private const int Samples = 16384;
    private const double OneSample = 1.0 / Samples;
    private static readonly double[] s_extinction = [0.1, 0.5, 2];

    // Of unpolarised light, by sines and tangents of the angles; index of the far side over that of the near side.
    private static double Reflectance(double angle, double index)
    {
        double sine = Math.Sin(angle) / index;
        if (sine >= 1)
        {
            return 1;
        }

        double refracted = Math.Asin(sine);
        if (angle == 0)
        {
            return Math.Pow((index - 1) / (index + 1), 2);
        }

        double across = Math.Sin(angle - refracted) / Math.Sin(angle + refracted);
        double along = Math.Tan(angle - refracted) / Math.Tan(angle + refracted);
        return ((across * across) + (along * along)) / 2;
    }

    private static void Scatter(Material material, double angle, bool inside, Action<Vector3, float> action)
    {
        SurfaceW surface = default;
        surface.Facing = Vector3.UnitZ;
        surface.Normal = inside ? -Vector3.UnitZ : Vector3.UnitZ;
        surface.Incoming = new Vector3((float)Math.Sin(angle), 0, -(float)Math.Cos(angle));
        surface.Cosine = (float)Math.Cos(angle);
        surface.Inside = inside ? MaskW.All : MaskW.None;
        VertexSamples samples = new(new SobolSampler(Count));
        for (int i = 0; i < Count; i++)
        {
            samples.Begin(Hash.PixelKey((uint)TestSettings.Seed, 1), (uint)i, 0u);
            material.Scatter(surface, samples, out ScatterW scatter);
            action(new(scatter.Direction.X[0], scatter.Direction.Y[0], scatter.Direction.Z[0]), scatter.Weight.G[0]);
        }
    }

    // The surface of a half space of glass, below a red sky and above a green ground, seen at an angle with the vertical.
    private static ImageSamples HalfSpace(double index, double angle, bool below)
    {
        (double sin, double cos) = Math.SinCos(angle);
        Vec3D eye = new(-5 * sin, (below ? -5 : 5) * cos, 0);
        return SceneRuns.RenderText(
            $$"""
            { "camera": { "position": {{eye}}, "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "integrator": "report", "width": 1, "height": 1, "samplesPerPixel": {{Samples}}, "maxSpecularDepth": 1 },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "dielectric", "refractiveIndex": {{index}} } },
                { "type": "plane", "point": [0, 100, 0], "normal": [0, -1, 0], "size": [10000, 10000], "material": { "type": "luminaire", "color": [1, 0, 0] } },
                { "type": "plane", "point": [0, -100, 0], "normal": [0, 1, 0], "size": [10000, 10000], "material": { "type": "luminaire", "color": [0, 1, 0] } } ] }
            """,
            TestSettings.Scale(4, 32));
    }

    // A ball of radius 2 in a white world, seen along a line at a distance (in radii) from its middle.
    private static ImageSamples Ball(double index, double distance, string extinction, int depth) => SceneRuns.RenderText(
        $$"""
        { "camera": { "position": {{new Vec3D(2 * distance, 0, 10)}}, "lookAt": {{new Vec3D(2 * distance, 0, 0)}}, "fieldOfView": 0.001 },
          "render": { "integrator": "report", "width": 1, "height": 1, "samplesPerPixel": {{Samples}}, "maxSpecularDepth": {{depth}} },
          "background": [1, 1, 1],
          "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "dielectric", "refractiveIndex": {{index}}, "extinction": {{extinction}} } } ] }
        """,
        TestSettings.Scale(8, 32));
}
