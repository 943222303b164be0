using RayTracer.Jobs;

namespace RayTracer.Study;

/// <summary>The page about a reproduction: machine, scenes, pictures, times and their growth.</summary>
/// <param name="plan">The sizes of the pictures.</param>
/// <param name="scenes">The measurements.</param>
/// <param name="machine">The machine that it was measured on.</param>
internal sealed class ReproductionPage(ReproductionPlan plan, IReadOnlyList<ReproducedScene> scenes, Machine machine)
{
    /// <summary>The page's title.</summary>
    public const string Title = "The report's test scenes, rendered again";

    /// <summary>The file of the chart.</summary>
    public const string ChartFile = "figure-6-6.svg";

    /// <summary>Writes everything.</summary>
    public void Write(PageWriter page)
    {
        page.Paragraph("Pictures and times after section 6.3 of “Real-time Ray Tracing” (group B123, Aalborg University, 2009), with jittered samples.");
        if (plan.IsQuick)
        {
            page.Paragraph($"This is a quick run: width and height are the report's divided by {plan.SizeDivisor}, numbers of samples above 16 those of the report divided by {plan.SamplesDivisor}. Such short times are inexact.");
        }

        page.Machine(machine);
        WriteScenes(page);
        WritePictures(page);
        WriteTimes(page);
        WriteFrames(page);
        WriteGrowth(page);
    }

    private static string Threads => Environment.ProcessorCount == 1 ? "1 thread" : $"{Environment.ProcessorCount} threads";

    private void WriteScenes(PageWriter page)
    {
        page.Heading("Table 6.1: scenes");
        page.Paragraph("Read from the scene files; in brackets the report's values.");
        page.Table(
            ["Scene", "Primitives", "Lights", "Resolution", "As in the report"],
            scenes.Select(s => (IReadOnlyList<string>)
            [
                $"{s.Scene.Number}", $"{s.Primitives} ({s.Scene.Primitives})", $"{s.Lights} ({s.Scene.Lights})",
                $"{s.Width}×{s.Height} ({s.Scene.Size}×{s.Scene.Size})", s.AgreesWithTheReport ? "yes" : "no",
            ]));
    }

    private void WritePictures(PageWriter page)
    {
        page.Heading("Figures 6.3, 6.4 and 6.5: pictures");
        foreach (ReproducedPicture p in scenes.SelectMany(s => s.Pictures))
        {
            page.Picture(p.Scene.PictureFile(p.Picture), $"{p.Name}: scene {p.Scene.Number}, {Settings(p.All)}, {Number(p.All.Seconds)} s with {Threads}");
        }
    }

    private void WriteTimes(PageWriter page)
    {
        page.Heading("Times");
        page.Paragraph($"The report's times are those of a {ReportScene.Machine}; its loop (listing 6.1) runs in one thread. Speed-up is the report's time for a primary ray over the time for one here; that of one thread is the speed-up per core. Times are of rendering alone, in seconds, the best of {plan.Rounds}. Rays include shadow rays.");
        page.Table(
            ["Figure", "Settings", "Report", Threads, "1 thread", $"{Threads}: 1 thread over it", $"Speed-up, {Threads}", "Speed-up, 1 thread", "Rays (millions)", $"M rays/s, {Threads}", "M rays/s, 1 thread"],
            scenes.SelectMany(s => s.Pictures).Select(p => (IReadOnlyList<string>)
            [
                p.Name, Settings(p.All), $"{p.Picture.Seconds:F3}", Number(p.All.Seconds), Number(p.One.Seconds), Number(p.One.Seconds / p.All.Seconds),
                Number(p.SpeedUp(p.All)), Number(p.SpeedUp(p.One)), Number(p.All.Rays / 1e6), Number(p.All.RaysPerSecond / 1e6), Number(p.One.RaysPerSecond / 1e6),
            ]));
    }

    private void WriteFrames(PageWriter page)
    {
        page.Heading("Pictures a second");
        page.Paragraph($"With one sample a pixel, rendered one after the other for {Number(plan.FrameSeconds)} s, the scene read beforehand. The report has 5 to 7 pictures a second at 100×100 pixels (section 6.3), and wishes for 800×600 (6.4).");
        page.Table(
            ["Scene", "Size", Threads, "1 thread", $"M rays/s, {Threads}"],
            scenes.SelectMany(s => s.Frames).Select(f => (IReadOnlyList<string>)
            [
                $"{f.Scene.Number}", $"{f.Width}×{f.Height}", Number(f.All), Number(f.One), Number(f.RaysPerSecond / 1e6),
            ]));
    }

    private void WriteGrowth(PageWriter page)
    {
        page.Heading("Figure 6.6: time against samples");
        page.Picture(ChartFile, $"Time against samples a pixel; left here with {Threads}, right in the report. Points are measured, curves are least-squares polynomials; three points determine no cubic, so they have a parabola.");
        page.Paragraph("The cubics of this machine, t = a + b·N + c·N² + d·N³ seconds for N samples a pixel. The last column is R² of the straight line of least squares: 1 would be exactly linear.");
        page.Table(
            ["Scene", "Points", "Largest N", "a", "b", "c", "d", "R² of a line"],
            scenes.Select(s =>
            {
                PolynomialFit fit = s.Fit;
                double largest = s.Growth.Max(m => m.SamplesPerPixel);
                return (IReadOnlyList<string>)
                [
                    $"{s.Scene.Number}", $"{s.Growth.Count}", $"{largest}", .. fit.Coefficients.Select(c => $"{c:0.00e+0}"), $"{PolynomialFit.Of(1, s.Points).Determination(s.Points):F4}",
                ];
            }));
    }

    private static string Settings(Measurement m) => $"{m.Size}×{m.Size}, {m.SamplesPerPixel} spp";

    // Three significant digits where there are decimals at all.
    private static string Number(double value) => value switch
    {
        >= 100 => $"{value:F0}",
        >= 10 => $"{value:F1}",
        >= 1 => $"{value:F2}",
        _ => $"{value:F3}",
    };
}
