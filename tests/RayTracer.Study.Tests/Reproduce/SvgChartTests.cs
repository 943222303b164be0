using System.Xml.Linq;

namespace RayTracer.Study.Tests;

public sealed class SvgChartTests
{
    private static readonly XNamespace Svg = "http://www.w3.org/2000/svg";
    private static readonly (double X, double Y)[] Points = [(1, 0.5), (4, 2), (9, 4.5), (16, 8)];

    [Fact]
    public void Chart_is_well_formed_and_has_every_point_in_its_place()
    {
        ChartSeries series = new("a < b & c", "#123456", Points, PolynomialFit.Of(3, Points).At);
        using MemoryStream file = new();
        SvgChart.Draw([new("Title", "x", "y", [series]), new("Second", "x", "y", [series with { Fit = null }])]).Save(file);
        file.Position = 0;
        XDocument chart = XDocument.Load(file);
        Assert.Equal(Svg + "svg", chart.Root!.Name);
        Assert.Equal(2, chart.Descendants(Svg + "text").Count(t => t.Value == "a < b & c"));
        Assert.Single(chart.Descendants(Svg + "polyline"));
        XElement[] circles = [.. chart.Descendants(Svg + "circle")];
        Assert.Equal(2 * Points.Length, circles.Length);
        for (int i = 1; i < Points.Length; i++)
        {
            // The points lie on a line through the origin, so that their distances from the first are in proportion.
            double part = (Points[i].X - Points[0].X) / (Points[^1].X - Points[0].X);
            Assert.Equal(part, Part(circles, i, "cx"), 0.001);
            Assert.Equal(part, Part(circles, i, "cy"), 0.001);
        }
    }

    [Fact]
    public void Lines_join_points_and_the_legend_stands_beside_them()
    {
        ChartSeries series = new("name", "#123456", Points, Fit: null) { IsJoined = true };
        XElement chart = SvgChart.Draw([new("Title", "x", "y", [series], IsLogarithmic: true) { HasLegendAside = true }]).Root!;
        string[] corners = [.. chart.Descendants(Svg + "circle").Select(c => $"{c.Attribute("cx")!.Value},{c.Attribute("cy")!.Value}")];
        Assert.Equal(corners, chart.Descendants(Svg + "polyline").Single().Attribute("points")!.Value.Split(' '));
        double Legend(XElement of) => (double)of.Descendants(Svg + "text").Single(t => t.Value == "name").Attribute("x")!;
        Assert.True(Legend(chart) > chart.Descendants(Svg + "line").Max(l => (double)l.Attribute("x1")!));
        Assert.InRange(Legend(SvgChart.Draw([new("Title", "x", "y", [series])]).Root!), 0, 300);
    }

    [Theory]
    [InlineData(400, 100, 4, "400")]
    [InlineData(2119.9, 500, 5, "2500")]
    [InlineData(0.16, 0.05, 4, "0.2")]
    [InlineData(6, 1, 6, "6")]
    [InlineData(1e-7, 2e-8, 5, "0.0000001")]
    public void Axis_has_round_ticks_up_to_the_largest_value(double largest, double step, int count, string last)
    {
        ChartAxis axis = new(largest);
        Assert.Equal(step, axis.Step, step * 1e-9);
        Assert.Equal(count, axis.Count);
        Assert.Equal(last, axis.Label(axis.Count));
        Assert.Equal("0", axis.Label(0));
    }

    private static double Part(XElement[] circles, int i, string coordinate)
    {
        double At(int circle) => (double)circles[circle].Attribute(coordinate)!;
        return (At(i) - At(0)) / (At(Points.Length - 1) - At(0));
    }
}
