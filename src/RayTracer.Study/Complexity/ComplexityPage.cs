using RayTracer.Jobs;

namespace RayTracer.Study;

/// <summary>The page about a study: the question, the chart, and the figures.</summary>
internal sealed class ComplexityPage(ComplexityPlan plan, ComplexityStudy study, Machine machine)
{
    /// <summary>The page's title.</summary>
    public const string Title = "What a ray costs, by the number of triangles";

    /// <summary>The file of the chart.</summary>
    public const string ChartFile = "complexity.svg";

    /// <summary>The chart of what was measured.</summary>
    public ChartPanel Panel => new(
        "One thread",
        "triangles",
        "time a ray in nanoseconds",
        [.. Measured.Select(m => new ChartSeries(m.Name, m.Colour, PointsOf(m), FitOf(m)!.At))],
        IsLogarithmic: true);

    private IEnumerable<Method> Measured => Method.All.Where(m => study.Points[m].Count > 1);

    /// <summary>Writes everything.</summary>
    public void Write(PageWriter page)
    {
        page.Paragraph("The 2009 report “Real-time Ray Tracing” (group B123, Aalborg University) tests every ray against every primitive, says that this is O(n) (section 6.3.1), and hopes for a hierarchy that makes it O(log n) (section 6.4). Here both are measured, with all the structures of its sections 3.5 and 6.1 beside them.");
        page.Paragraph($"The scene is a landscape of n triangles; {plan.Rays} rays from outside in random directions, one thread, the best of {plan.Rounds}. Loop, grid and trees are those of the textbook edition: scalar code in double precision, written to be read; the two BVHs are the renderer's own, with eight boxes or triangles for each instruction, by single rays and by streams of rays.");
        page.Picture(
            ChartFile, "Time a ray against the number of triangles; both axes are logarithmic. Points are measured, curves are fitted.");
        page.Machine(machine);
        page.Heading("Laws");
        page.Paragraph("Curves a + b·f(n) in nanoseconds, by least squares of relative deviations. What deviates upwards at the right end does so where the triangles no longer fit into the processor's caches.");
        page.Table(
            ["Method", "f(n)", "a", "b", "Largest deviation"],
            Measured.Select(m => (IReadOnlyList<string>)[m.Name, m.Law, $"{FitOf(m).Constant:G3}", $"{FitOf(m).Factor:G3}", $"{FitOf(m).LargestDeviation(PointsOf(m)):P0}"]));
        page.Heading("Nanoseconds a ray");
        WriteTable(page, p => Number(p.NanosecondsPerRay));
        page.Heading("Seconds to build");
        page.Paragraph("The BVHs are built by all threads, the others by one.");
        WriteTable(page, p => Number(p.BuildSeconds));
        page.Heading("Bytes a triangle");
        page.Paragraph("Beside corners and indices, which all have.");
        WriteTable(page, p => Number(p.BytesPerTriangle));
        foreach ((Method method, int count) in study.LeftOut)
        {
            page.Paragraph(
                $"{method.Name}: left out from {count} triangles on, for it would have taken more than {plan.SecondsEach:F0} s.");
        }

        page.Paragraph($"Of all rays, {study.Disagreements} met another triangle by one method than by another: rays through an edge that two triangles share.");
    }

    private static string Number(double value) => value switch
    {
        >= 100 => $"{value:F0}",
        >= 1 => $"{value:G3}",
        >= 0.001 => $"{value:F3}",
        _ => "< 0.001",
    };

    private (double X, double Y)[] PointsOf(Method method) =>
        [.. study.Points[method].Select(p => ((double)p.Triangles, p.NanosecondsPerRay))];

    private GrowthFit FitOf(Method method) => GrowthFit.Of(method.Growth, PointsOf(method));

    private void WriteTable(PageWriter page, Func<ComplexityPoint, string> value) => page.Table(
        ["Triangles", .. Method.All.Select(m => m.Name)],
        plan.Counts.Where(n => study.Points.Values.Any(points => points.Exists(p => p.Triangles == n))).Select(n => (IReadOnlyList<string>)
        [
            $"{n}", .. Method.All.Select(m => study.Points[m].Find(p => p.Triangles == n) is { } point ? value(point) : "–"),
        ]));
}
