using System.Numerics;
using System.Xml.Linq;
using RayTracer.Jobs;
using RayTracer.Shapes;

namespace RayTracer.Study.Tests;

public sealed class ComplexityTests : IDisposable
{
    private static readonly ComplexityPlan Tiny = new([10, 30, 100], 200, 60, 1);
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Small_run_measures_every_method_and_writes_chart_and_pages()
    {
        using StringWriter output = new();
        new ComplexityRun(Tiny, _folder["new"], output).Run(CancellationToken.None);
        Assert.Equal(["complexity.svg", "index.html", "index.md", "visible-painter.png", "visible-rays.png", "visible-z-buffer.png", "visible.svg"], Directory.GetFiles(_folder["new"]).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        XDocument chart = XDocument.Load(Path.Combine(_folder["new"], "complexity.svg"));
        Assert.Equal(Method.All.Count * Tiny.Counts.Count, chart.Descendants().Count(e => e.Name.LocalName == "circle"));
        string page = File.ReadAllText(Path.Combine(_folder["new"], "index.md"));
        Assert.All(Method.All, m => Assert.Contains(m.Name, page, StringComparison.Ordinal));
    }

    [Fact]
    public void All_methods_find_the_same_triangles()
    {
        MeshData mesh = Terrain.Create(1000);
        (Vector3 Origin, Vector3 Direction)[] rays = Terrain.Rays(2000);
        int[][] hits = [.. Method.All.Select(m =>
        {
            int[] found = new int[rays.Length];
            m.Build(mesh).Trace(rays, found);
            return found;
        })];
        Assert.InRange(hits[0].Count(h => h >= 0), 500, 2000);

        // A ray through an edge may go to either side by another test of triangles.
        Assert.All(hits, h => Assert.InRange(h.Zip(hits[0]).Count(pair => pair.First != pair.Second), 0, 2));
    }

    [Fact]
    public void The_rasterizer_finds_the_triangles_of_the_picture_s_rays()
    {
        const int Side = 100;
        MeshData mesh = Terrain.Create(3000);
        (Vector3 Origin, Vector3 Direction)[] rays = [.. Enumerable.Range(0, Side * Side).Select(i => TerrainView.RayOf(i, Side))];
        int[][] hits = [.. Method.OfPictures.Select(m =>
        {
            int[] found = new int[rays.Length];
            m.Build(mesh).Trace(rays, found);
            return found;
        })];
        Assert.InRange(hits[0].Count(h => h >= 0), 3000, 10_000);

        // Rays are in single precision.
        Assert.All(hits, h => Assert.InRange(h.Zip(hits[0]).Count(pair => pair.First != pair.Second), 0, 5));
    }

    [Fact]
    public void The_place_where_both_ways_cross_lies_between_the_measurements_around_it()
    {
        ComplexityStudy picture = ComplexityStudy.OfPicture(Tiny);
        (Method raster, Method rays) = (Method.OfPictures[0], Method.OfPictures[1]);
        picture.Points[raster].AddRange([new(10, 1, 0, 0), new(100, 10, 0, 0), new(1000, 100, 0, 0)]);
        picture.Points[rays].AddRange([new(10, 20, 0, 0), new(100, 20, 0, 0), new(1000, 20, 0, 0)]);
        ComplexityPage page = new(Tiny, new(Tiny), picture, Machine.Now());
        Assert.Equal(200, page.Crossing(rays)!.Value, 6);
        Assert.Null(page.Crossing(Method.OfPictures[2]));
    }

    [Theory]
    [InlineData(10)]
    [InlineData(100)]
    [InlineData(3000)]
    [InlineData(100_000)]
    public void Landscape_has_as_many_triangles_as_wanted_and_is_whole(int triangles)
    {
        MeshData mesh = Terrain.Create(triangles);
        Assert.Equal(triangles, mesh.TriangleCount);
        double area = 0;
        for (int t = 0; t < triangles; t++)
        {
            Vector3 a = mesh.Positions[mesh.Indices[3 * t]];
            Vector3 b = mesh.Positions[mesh.Indices[(3 * t) + 1]];
            Vector3 c = mesh.Positions[mesh.Indices[(3 * t) + 2]];
            area += Vector3.Cross(b - a, c - a).Y / 2;
        }

        Assert.Equal(1, area, 4);
    }

    [Fact]
    public void A_fit_finds_the_curve_that_points_lie_on()
    {
        (double X, double Y)[] points = [.. new[] { 10.0, 100, 1000, 1e6 }.Select(n => (n, 30 + (7 * Math.Log2(n))))];
        GrowthFit fit = GrowthFit.Of(Math.Log2, points);
        Assert.Equal(30, fit.Constant, 6);
        Assert.Equal(7, fit.Factor, 6);
        Assert.Equal(0, fit.LargestDeviation(points), 9);
        points[^1].Y *= 1.5;
        Assert.InRange(GrowthFit.Of(Math.Log2, points).LargestDeviation(points), 0.05, 0.5);
    }

    [Fact]
    public void A_method_that_would_take_too_long_is_left_out_and_the_page_says_so()
    {
        ComplexityPlan hasty = Tiny with { Counts = [10, 100, 100_000], SecondsEach = 1e-9 };
        ComplexityStudy study = new(hasty);
        study.Run((_, _) => { }, CancellationToken.None);
        Assert.Equal(100, study.LeftOut[Method.All[0]]);
        MarkdownPage page = new(ComplexityPage.Title);
        new ComplexityPage(hasty, study, ComplexityStudy.OfPicture(hasty), Jobs.Machine.Now()).Write(page);
        Assert.Contains("left out from 100 triangles on", page.Finish(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(20, 3000, "10¹", "10⁴")]
    [InlineData(10, 1000, "10¹", "10³")]
    [InlineData(0.002, 0.02, "10⁻³", "10⁻¹")]
    [InlineData(5, 5, "10⁰", "10¹")]
    public void Logarithmic_axis_begins_and_ends_at_powers_of_ten(double smallest, double largest, string first, string last)
    {
        LogarithmicAxis axis = new(smallest, largest);
        Assert.Equal((first, last), (axis.Ticks.First().Label, axis.Ticks.Last().Label));
        Assert.Equal(0, axis.Place(axis.Ticks.First().Value), 9);
        Assert.Equal(1, axis.Place(axis.Ticks.Last().Value), 9);
        Assert.Equal(largest, axis.ValueAt(axis.Place(largest)), 9);
    }
}
