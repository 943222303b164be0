using RayTracer.Jobs;

namespace RayTracer.Study;

/// <summary>The page about a study: the question, the chart, and the figures.</summary>
/// <param name="plan">The numbers of triangles.</param>
/// <param name="study">Rays in random directions.</param>
/// <param name="picture">Rays of a picture, and the rasterizer.</param>
/// <param name="machine">The machine.</param>
internal sealed class ComplexityPage(ComplexityPlan plan, ComplexityStudy study, ComplexityStudy picture, Machine machine)
{
    /// <summary>The page's title.</summary>
    public const string Title = "What a ray costs, by the number of triangles";

    /// <summary>The file of the chart.</summary>
    public const string ChartFile = "complexity.svg";

    /// <summary>The file of the chart of pictures.</summary>
    public const string PictureChartFile = "visible.svg";

    /// <summary>The chart of what was measured.</summary>
    public ChartPanel Panel => PanelOf(study, "One thread", "time a ray in nanoseconds");

    /// <summary>The chart of pictures.</summary>
    public ChartPanel PicturePanel => PanelOf(picture, "Two ways to find what is visible, one thread", "time a pixel in nanoseconds");

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
            Measured(study).Select(m => (IReadOnlyList<string>)[m.Name, m.Law, $"{FitOf(study, m).Constant:G3}", $"{FitOf(study, m).Factor:G3}", $"{FitOf(study, m).LargestDeviation(PointsOf(study, m)):P0}"]));
        page.Heading("Nanoseconds a ray");
        WriteTable(page, study, p => Number(p.NanosecondsPerRay));
        page.Heading("Seconds to build");
        page.Paragraph("The BVHs are built by all threads, the others by one.");
        WriteTable(page, study, p => Number(p.BuildSeconds));
        page.Heading("Bytes a triangle");
        page.Paragraph("Beside corners and indices, which all have.");
        WriteTable(page, study, p => Number(p.BytesPerTriangle));
        foreach ((Method method, int count) in study.LeftOut)
        {
            page.Paragraph(
                $"{method.Name}: left out from {count} triangles on, for it would have taken more than {plan.SecondsEach:F0} s.");
        }

        page.Paragraph($"Of all rays, {study.Disagreements} met another triangle by one method than by another: rays through an edge that two triangles share.");
        WritePictures(page);
    }

    private void WritePictures(PageWriter page)
    {
        page.Heading("Two ways to find what is visible");
        page.Paragraph("A rasterizer asks for each triangle which pixels it covers, and keeps the nearest; a ray tracer asks for each pixel which triangle it meets. The same picture of the landscape by both, a pixel at a time: the rasterizer's time grows with the number of triangles, that of rays with its logarithm. Trees were built before.");
        page.Picture(PictureChartFile, "Time a pixel against the number of triangles; both axes are logarithmic.");
        WriteTable(page, picture, p => Number(p.NanosecondsPerRay));
        foreach (Method rays in Method.OfPictures.Skip(1))
        {
            page.Paragraph(Crossing(rays) is { } n ? $"The rasterizer is slower than {rays.Name} from about {n:G2} triangles on." : $"The rasterizer is slower than {rays.Name}, or faster, at all numbers of triangles here: they do not cross.");
        }

        page.Paragraph($"Of all pixels, {picture.Disagreements} show another triangle by one method than by another: those whose middle lies on an edge but for rounding.");
        foreach ((string file, string caption, _) in TwoWays.Pictures)
        {
            page.Picture(file, caption);
        }
    }

    /// <summary>The number of triangles from which on the rasterizer is slower than a method that traces rays; null where there is none.</summary>
    public double? Crossing(Method rays)
    {
        (double X, double Ratio)[] ratios = [.. picture.Points[Method.OfPictures[0]].Join(
            picture.Points[rays], r => r.Triangles, t => t.Triangles, (r, t) => ((double)r.Triangles, Math.Log(r.NanosecondsPerRay / t.NanosecondsPerRay)))];
        int below = Array.FindLastIndex(ratios, r => r.Ratio <= 0);
        if (below < 0 || below == ratios.Length - 1)
        {
            return null;
        }

        // On logarithmic axes, a straight line between two measurements.
        ((double x, double low), (double next, double high)) = (ratios[below], ratios[below + 1]);
        return x * Math.Pow(next / x, -low / (high - low));
    }

    private static ChartPanel PanelOf(ComplexityStudy study, string title, string time) => new(
        title, "triangles", time, [.. Measured(study).Select(m => new ChartSeries(m.Name, m.Colour, PointsOf(study, m), FitOf(study, m).At))], IsLogarithmic: true);

    private static IEnumerable<Method> Measured(ComplexityStudy study) => study.Methods.Where(m => study.Points[m].Count > 1);

    private static string Number(double value) => value switch
    {
        >= 100 => $"{value:F0}",
        >= 1 => $"{value:G3}",
        >= 0.001 => $"{value:F3}",
        _ => "< 0.001",
    };

    private static (double X, double Y)[] PointsOf(ComplexityStudy study, Method method) =>
        [.. study.Points[method].Select(p => ((double)p.Triangles, p.NanosecondsPerRay))];

    private static GrowthFit FitOf(ComplexityStudy study, Method method) => GrowthFit.Of(method.Growth, PointsOf(study, method));

    private void WriteTable(PageWriter page, ComplexityStudy measured, Func<ComplexityPoint, string> value) => page.Table(
        ["Triangles", .. measured.Methods.Select(m => m.Name)],
        plan.Counts.Where(n => measured.Points.Values.Any(points => points.Exists(p => p.Triangles == n))).Select(n => (IReadOnlyList<string>)
        [
            $"{n}", .. measured.Methods.Select(m => measured.Points[m].Find(p => p.Triangles == n) is { } point ? value(point) : "–"),
        ]));
}
