using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Scenes;
using RayTracer.Testing;
using RayTracer.Tests.Statistics;

namespace RayTracer.Tests.Sampling;

[Trait("Category", "Thorough")]
public class PixelFilterTests
{
    private const double Rare = 0.02;

    // What the straight lines between the places of the curve's table may differ from it.
    private const double Rounding = 2e-5;
    private static readonly Dictionary<string, FilterDescription> s_filters = new()
    {
        ["wide box"] = new() { Shape = FilterShape.Box, Radius = 1.25f },
        ["tent"] = new() { Shape = FilterShape.Tent, Radius = 1 },
        ["gaussian"] = new() { Shape = FilterShape.Gaussian, Radius = 1.5f },
        ["gaussian cut off at four deviations"] = new() { Shape = FilterShape.Gaussian, Radius = 2, Deviation = 0.5f },
        ["gaussian cut off at eight deviations"] = new() { Shape = FilterShape.Gaussian, Radius = 4, Deviation = 0.5f },
        ["mitchell"] = new() { Shape = FilterShape.Mitchell, Radius = 2 },
        ["Catmull-Rom"] = new() { Shape = FilterShape.Mitchell, Radius = 2, B = 0, C = 0.5f },
        ["B-spline"] = new() { Shape = FilterShape.Mitchell, Radius = 2, B = 1, C = 0 },
        ["large lobes"] = new() { Shape = FilterShape.Mitchell, Radius = 3, B = 0, C = 1 },
        ["Blackman-Harris"] = new() { Shape = FilterShape.BlackmanHarris, Radius = 1.5f },
    };

    public static TheoryData<string> Names => new(s_filters.Keys);

    [Theory]
    [MemberData(nameof(Names))]
    public void Samples_are_spread_as_the_magnitude_of_the_curve(string name)
    {
        const int cells = 96;
        FilterDescription description = s_filters[name];
        PixelFilter filter = PixelFilter.Create(description)!;
        double[] across = new double[cells];
        double[] along = new double[cells];
        int count = TestSettings.Scale(1 << 18, 1 << 22);
        UnitSquare.AtRandom(count, (u, v, lane) =>
        {
            filter.Place(ref u, ref v);
            across[Cell(u[lane])]++;
            along[Cell(v[lane])]++;
        });
        double[] expected = [.. Enumerable.Range(0, cells).Select(i => count * FilterIntegral.MagnitudeShare(description, Edge(i), Edge(i + 1)))];
        ErrorBudget.Filters.Check(PValues.ChiSquared(across, expected), $"{name}, columns");
        ErrorBudget.Filters.Check(PValues.ChiSquared(along, expected), $"{name}, rows");

        double Edge(int cell) => description.Radius * ((2.0 * cell / cells) - 1);
        int Cell(float place) => Math.Clamp((int)Math.Floor((place - 0.5 + description.Radius) / (2 * description.Radius) * cells), 0, cells - 1);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Weighted_samples_have_the_moments_of_the_curve(string name)
    {
        // Without noise, on a fine grid: white stays white, nothing is shifted, and the second moment is the curve's.
        FilterDescription description = s_filters[name];
        PixelFilter filter = PixelFilter.Create(description)!;
        double[] moments = new double[4];
        UnitSquare.OnGrid(9, (u, v, lane) =>
        {
            double weight = filter.Weight(u, v)[lane];
            filter.Place(ref u, ref v);
            double x = u[lane] - 0.5;
            double[] terms = [1, x, x * x, (v[lane] - 0.5) * x];
            for (int k = 0; k < terms.Length; k++)
            {
                moments[k] += weight * terms[k] / (512 * 512);
            }
        });
        double second = Enumerable.Range(0, 400).Sum(i =>
        {
            double x = description.Radius * ((i + 0.5) / 200 - 1);
            return x * x * FilterIntegral.Share(description, x - (description.Radius / 400), x + (description.Radius / 400));
        });
        Assert.Equal(1, moments[0], filter.HasWeights ? 5e-3 : 1e-7);
        Assert.Equal(0, moments[1], 1e-4);
        Assert.Equal(second, moments[2], 5e-3);
        Assert.Equal(0, moments[3], 1e-4);
    }

    [Fact]
    public void Tent_is_the_closed_form()
    {
        PixelFilter filter = PixelFilter.Create(new() { Shape = FilterShape.Tent })!;
        foreach (float u in new[] { 0, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 0.99f })
        {
            (FloatW x, FloatW y) = (u, 1f - u);
            filter.Place(ref x, ref y);
            double t = (2.0 * u) - 1;
            Assert.Equal(0.5 + (Math.Sign(t) * (1 - Math.Sqrt(1 - Math.Abs(t)))), x[0], 1e-6);
            Assert.Equal(1, x[0] + y[0], 1e-6f);
        }
    }

    [Fact]
    public void Only_curves_with_negative_lobes_have_weights()
    {
        Assert.All(s_filters, f => Assert.Equal(f.Value is { Shape: FilterShape.Mitchell, C: > 0 }, PixelFilter.Create(f.Value)!.HasWeights));
        Assert.All(s_filters.Where(f => f.Value.C == 0 || f.Value.Shape != FilterShape.Mitchell), f => Assert.Equal(1, PixelFilter.Create(f.Value)!.Weight(0.999f, 0.001f)[0]));
        FloatW weight = PixelFilter.Create(s_filters["mitchell"])!.Weight(0.999f, 0.5f);
        Assert.InRange(weight[0], -1.6f, -1);
    }

    [Fact]
    public void Numbers_at_the_ends_stay_within_the_radius_and_are_numbers()
    {
        foreach ((string name, FilterDescription description) in s_filters)
        {
            foreach (float u in new[] { 0, float.Epsilon, 0.5f - (1f / (1 << 25)), 0.5f, 0.5f + (1f / (1 << 24)), 1 - (1f / (1 << 24)) })
            {
                (FloatW x, FloatW y) = (u, u);
                PixelFilter.Create(description)!.Place(ref x, ref y);
                Assert.True(Math.Abs(x[0] - 0.5f) <= description.Radius * 1.000001f, $"{name} at {u}: {x[0]}");
            }
        }
    }

    [Theory]
    [InlineData(0.01f, true)]
    [InlineData(0.02f, false)]
    public void Samples_of_a_filter_narrower_than_a_64th_of_a_pixel_are_taken_in_the_middle(float radius, bool isMiddle)
    {
        (FloatW x, FloatW y) = (0.25f, 0.9f);
        PixelFilter.Create(new() { Radius = radius })!.Place(ref x, ref y);
        Assert.Equal(isMiddle ? 0.5f : 0.5f - (0.5f * radius), x[0], 1e-6f);
        Assert.Equal(isMiddle ? 0.5f : 0.5f + (0.8f * radius), y[0], 1e-6f);
    }

    [Fact]
    public void The_default_is_the_mean_over_the_pixel_to_the_bit()
    {
        Assert.Null(PixelFilter.Create(new()));
        Assert.Null(PixelFilter.Create(new() { Shape = FilterShape.Box, Radius = 0.5f }));
        Assert.NotNull(PixelFilter.Create(new() { Shape = FilterShape.Box, Radius = 0.75f }));
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void An_edge_looks_as_the_integral_of_the_curve(string name)
    {
        // Orthographic, a pixel a unit; what shines begins 0.3 pixels beyond the middle of the picture.
        FilterDescription filter = s_filters[name];
        ImageSamples images = SceneRuns.RenderText(
            """
            {
              "camera": { "projection": "orthographic", "position": [0, 0, 5], "lookAt": [0, 0, 0], "viewSize": 4 },
              "render": { "integrator": "report", "width": 12, "height": 4, "samplesPerPixel": 256 },
              "lights": [{ "type": "rectangle", "corner": [0.3, -50, 0], "edgeU": [100, 0, 0], "edgeV": [0, 100, 0], "material": { "type": "luminaire" } }]
            }
            """,
            TestSettings.Scale(16, 64),
            d => d with { Render = d.Render with { Filter = filter } });
        for (int x = 0; x < 12; x++)
        {
            double toEdge = 0.3 - (x + 0.5 - 6);
            double expected = FilterIntegral.Share(filter, toEdge, filter.Radius);
            BlockEstimate seen = images.Estimate(new(x, 0, 1, 4), 0);
            double share = FilterIntegral.MagnitudeShare(filter, toEdge, filter.Radius);
            if (Math.Min(share, 1 - share) < Rare)
            {
                // Samples beyond the edge, or on this side of it, are too few for a mean to be normal.
                Assert.Equal(expected, seen.Mean, 2 * Rare);
                continue;
            }

            double off = Math.Max(0, Math.Abs(seen.Mean - expected) - Rounding);
            double p = off == 0 ? 1 : PValues.StudentT(off / Math.Sqrt(seen.Variance), images.Count - 1);
            ErrorBudget.Filters.Check(p, string.Create(CultureInfo.InvariantCulture, $"{name}, column {x}: {seen.Mean} for {expected}"));
        }
    }

    [Fact]
    public void Samples_that_are_followed_again_make_up_what_the_film_has()
    {
        Scene scene = SceneRuns.Load(ProjectFolder.PathOf("scenes", "minimal.json"), d => d with
        {
            Render = d.Render with { Width = 24, Height = 16, SamplesPerPixel = 16, Filter = new() { Shape = FilterShape.Mitchell } },
        });
        Film film = new RTracer(scene).Render().Film;
        IReadOnlyList<TracedPath> paths = new PathTracing(scene).Trace(11, 7, new(0, 16));
        Assert.Contains(paths, p => p.Weight < 0);
        Assert.Equal(film.Mean(11, 7).G, paths.Sum(p => (double)p.Weight * p.Radiance.G) / 16, 1e-6);
    }
}
