using RayTracer.Cli.Reproduce;

namespace RayTracer.Cli.Complexity;

/// <summary><c>raytracer reproduce complexity</c>: measures, and writes chart and pages.</summary>
/// <param name="plan">How many triangles.</param>
/// <param name="folder">Where to; made if it is missing.</param>
/// <param name="streams">Where to say how far it is.</param>
internal sealed class ComplexityRun(ComplexityPlan plan, string folder, Streams streams)
{
    /// <summary>Does everything.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    /// <exception cref="CommandException">The folder cannot be used.</exception>
    public int Run()
    {
        OutputFolder output = new(folder, streams);
        output.Prepare(ComplexityPage.ChartFile);
        using StopSignals signals = new(streams);
        ComplexityStudy study = new(plan);
        try
        {
            study.Run(Report, signals.Token);
        }
        catch (OperationCanceledException)
        {
            streams.Warn("stopped; nothing was written");
            return signals.Status;
        }

        ComplexityPage page = new(plan, study);
        output.Write(ComplexityPage.ChartFile, SvgChart.Draw([page.Panel]));
        output.WritePages(ComplexityPage.Title, page.Write);
        return ExitStatus.Fine;
    }

    private void Report(Method method, ComplexityPoint point) =>
        streams.Output.WriteLine($"{point.Triangles} triangles, {method.Name}: {point.NanosecondsPerRay:F0} ns a ray, built in {point.BuildSeconds:F3} s");
}
